#pragma once

#include <memory>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the oracles "ode" and "ode/quick" of the Open Dynamics Engine. Both simulate
 worlds, the first with dWorldStep, the second with dWorldQuickStep (ode_world.h). The
 second answers no contact queries.

 "ode" answers contact queries with dCollide(), up to eight contacts per pair.

 The translation does the following:
 - geoms are created for each question, in no space and no world;
 - dContactGeom::normal points into g1, i.e. from B to A: negated;
 - dContactGeom::depth is positive when penetrating: negated;
 - dContactGeom::pos is a surface point for some pairs: moved midway
   (ode_contact_point.h);
 - sides, and lengths of capsules and cylinders, are full sizes: half sizes are doubled;
 - a half-space is a dPlane, which has no pose: n·x = d is computed in the world frame;
 - dCreateConvex requires faces: they are computed here (convex_facets.h). If the body
   origin is not inside the hull, the vertices are shifted so that the geom's origin is,
   which rounds each once more;
 - the answer's normal and separation are those of the deepest contact.

 ODE returns no distance for pairs that are apart, and has no cones. Source:
 ode/contact.h, "Describe the contact point between two geoms", and measurement. */
std::vector<std::unique_ptr<Oracle>> OdeOracles();

}  // namespace touchstone
