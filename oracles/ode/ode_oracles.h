#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns "ode" and "ode/quick". Both step worlds, the first by dWorldStep, the second
 by dWorldQuickStep (ode_world.h); the second answers no contact queries.

 "ode" answers by dCollide() of the Open Dynamics Engine, up to eight contacts a pair.

 What the translation hides:
 - geoms are made for each question, in no space and no world;
 - dContactGeom::normal points into g1, i.e. B to A: negated;
 - dContactGeom::depth is positive when penetrating: negated;
 - dContactGeom::pos is a surface point for some pairs: moved midway
 (ode_contact_point.h);
 - sides, capsule and cylinder lengths are given in full: half sizes are doubled;
 - a half-space is a dPlane, which has no pose: n·x = d is worked out in the world;
 - dCreateConvex wants faces: worked out here (convex_facets.h). Where the body origin is
 not inside the hull, its vertices are moved so that ODE's is, one more rounding each;
 - the answer's normal and separation are those of the deepest contact.

 ODE says nothing of pairs that are apart, and has no cones. Source: ode/contact.h,
 "Describe the contact point between two geoms", and measurement. */
std::vector<std::unique_ptr<Oracle>> OdeOracles();

}  // namespace touchstone
