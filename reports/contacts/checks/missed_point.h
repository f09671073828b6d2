#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns a point of `patch` that lies farther from the hull of the contacts than
 `legal` [-], see UnspannedAt(), and is certified to belong to the patch: a contact there
 of that `separation` [m] has its points on both surfaces, to within 2 e. Corners are
 tried first. The polygon around a disc is 2 % wider than the disc, so they are then drawn
 to the middle in such steps.

 A corner is off by `e` [m] where a face is flat to within e, and a contact may be off by
 e.
 @pre The patch has a vertex; `n_W` is a unit vector. */
std::optional<Eigen::Vector3d> CertainlyMissed(
    const ContactQuery& query, const ContactPatch& patch, const Eigen::Vector3d& n_W,
    double separation, std::span<const ContactPoint> contacts, double legal, double e);

}  // namespace touchstone
