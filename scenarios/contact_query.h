#pragma once

#include "scenarios/pose.h"
#include "scenarios/shape.h"

namespace touchstone {

/** A shape placed in the world. */
struct Body {
  Shape shape;
  Pose X_WB;
};

/** The question: do A and B touch, how deep or how far apart, where, and along what
 normal?

 Any oracle may be asked any valid query (scenarios/validate.h); what it cannot answer is
 `unsupported`. */
struct ContactQuery {
  Body A;
  Body B;
};

/** Returns the size of the scene: the largest |coordinate| a computation on the query has
 to carry, max over both bodies of |p_WB|_inf + bounding radius. Rounding errors are
 multiples of this times the unit roundoff. [m] */
double SceneSize(const ContactQuery& query);

}  // namespace touchstone
