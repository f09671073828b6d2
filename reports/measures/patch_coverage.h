#pragma once

#include <span>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns the share of the patch's extent that its contacts leave unspanned, in [0, 1].
 [-]

 The patch and the contacts are seen along `n_AB_W`, the patch stretched to unit spread
 along its principal axes so that a slab's width counts like its length; the value is the
 largest distance of a corner from the hull of the contacts, over the patch's diameter.
 One contact in the middle of a square face gives 1/2: a stack on it tips over. 1 where
 there is no contact, 0 for a patch that is a point.
 @pre The patch has a vertex; `n_AB_W` is a unit vector. */
double PatchUnspanned(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                      std::span<const ContactPoint> contacts);

/** Returns the share of the patch's extent that a computation may leave unspanned whose
 lengths are off by `e` [m]. [-]

 What is left of a convex set when its sides move inwards by e holds the set shrunk by
 e / r about the centre of its incircle, whose radius r is at least area / perimeter, half
 the length of a segment. Shrinking is the same seen along stretched axes.
 @pre The patch has two vertices; `n_AB_W` is a unit vector. */
double PatchBlur(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W, double e);

/** What a triangle inscribed in a disc leaves of the disc's diameter: half the radius. A
 manifold that does better holds any face up; two opposite corners of a square, or three
 of them, leave half its diagonal and do worse. [-] */
inline constexpr double kLegalUnspanned = 0.25;

/** Returns kLegalUnspanned as it is seen of `patch`. A disc of radius r is given by a
 polygon of k corners around it, at r / cos(π/k), from which the side of the triangle is
 still r / 2 away from the centre: (r / cos(π/k) − r / 2) of a diameter of 2 r / cos(π/k)
 is ½ − ¼ cos(π/k). [-] */
double LegalUnspanned(const ContactPatch& patch);

}  // namespace touchstone
