#pragma once

#include <optional>

#include <Eigen/Core>

#include "oracles/contact_answer.h"

namespace touchstone {

/** Returns the deepest contact of an answer, or nullptr without contacts. */
const ContactPoint* DeepestOf(const ContactAnswer& answer);

/** Returns the normal that an answer states, as a unit vector: its own, otherwise that of
 its deepest contact. */
std::optional<Eigen::Vector3d> NormalOf(const ContactAnswer& answer);

/** Returns the separation that an answer states: its own, otherwise that of its deepest
 contact. [m] */
std::optional<double> SeparationOf(const ContactAnswer& answer);

}  // namespace touchstone
