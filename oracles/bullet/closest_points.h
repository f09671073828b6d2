#pragma once

#include "oracles/bullet/bullet_algorithm.h"

namespace touchstone {

/** Bullet's closest points of two convex shapes: btGjkPairDetector, which hands
 penetrating pairs to btGjkEpaPenetrationDepthSolver. Gives witness points and no
 manifold.

 Reported by Bullet are the point on B, the unit normal on B (B to A) and the distance;
 the point on A is the former shifted by distance times normal (Bullet itself does this in
 btManifoldResult::addContactPoint). */
class ClosestPoints : public BulletAlgorithm {
 public:
  ContactAnswer Answer(const BulletPair& pair) override;
  double Separation(const BulletPair& pair) override;
};

}  // namespace touchstone
