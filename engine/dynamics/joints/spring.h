#pragma once

#include "engine/dynamics/joints/anchor.h"

namespace cookbook {

/** A massless spring-damper between two anchors. It pulls them together with the force
 k (ℓ − L) + b dℓ/dt, where ℓ is their distance. */
struct Spring {
  Anchor A;
  Anchor B;
  double stiffness = 0;    ///< k. [N/m], >= 0
  double damping = 0;      ///< b. [N s/m], >= 0
  double rest_length = 0;  ///< L. [m], >= 0
};

}  // namespace cookbook
