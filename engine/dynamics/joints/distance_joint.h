#pragma once

#include "engine/dynamics/joints/anchor.h"

namespace cookbook {

/** A distance joint: a massless rigid rod between two anchors. */
struct DistanceJoint {
  Anchor A;
  Anchor B;
  double length = 1;  ///< [m], > 0
};

}  // namespace cookbook
