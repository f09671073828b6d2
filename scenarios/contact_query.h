#pragma once

#include "scenarios/pose.h"
#include "scenarios/shape.h"

namespace touchstone {

/** A shape placed in the world. */
struct Body {
  Shape shape;
  Pose X_WB;
};

/** A contact query: do A and B touch, how deep or how far apart are they, where, and
 along which normal?

 Any valid query (scenarios/validate.h) may be put to any oracle; an oracle that cannot
 answer it returns `unsupported`. */
struct ContactQuery {
  Body A;
  Body B;
};

/** Returns the size of the scene: the maximum over both bodies of |p_WB|_inf + bounding
 radius. It bounds every |coordinate| in a computation on the query; rounding errors are
 multiples of it times the unit roundoff. [m] */
double SceneSize(const ContactQuery& query);

}  // namespace touchstone
