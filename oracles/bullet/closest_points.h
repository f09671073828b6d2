#pragma once

#include "oracles/bullet/bullet_algorithm.h"

namespace touchstone {

/** Bullet's closest points of two convex shapes: btGjkPairDetector, which passes
 penetrating pairs on to btGjkEpaPenetrationDepthSolver. Returns witness points but no
 manifold.

 Bullet reports the point on B, the unit normal on B (from B to A) and the distance. The
 point on A is the point on B shifted by distance times normal, as in Bullet's own
 btManifoldResult::addContactPoint. */
class ClosestPoints : public BulletAlgorithm {
 public:
  ContactAnswer Answer(const BulletPair& pair) override;
  double Separation(const BulletPair& pair) override;
};

}  // namespace touchstone
