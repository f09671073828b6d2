#pragma once

#include <string>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the definition of `double BestShift(shifts, p, n, depth)`, for engines that
 put a contact on either surface or midway: the shift along n after which the contact p of
 that depth, taken as midway, fits both surfaces best. Only boxes, capsules, cylinders and
 spheres have such contacts. Same formulas as in the adapters
 (oracles/ode/ode_contact_point.cc, oracles/dart/dart_contacts.cc). */
std::string BestShiftText(const ContactQuery& query);

/** Returns the shift to midway of a contact of a sphere and a box that lies on the box,
 or at the sphere's centre if that is in the box, as an expression of `half`, half the
 depth.
 @pre One body is a sphere and the other a box. */
std::string ShiftOfSphereAtBox(const ContactQuery& query);

}  // namespace touchstone
