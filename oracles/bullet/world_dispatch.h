#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "oracles/bullet/bullet_algorithm.h"

namespace touchstone {

/** The contacts that a stepped world would find in its first step: the algorithm that the
 dispatcher chooses for the pair, run once on an empty manifold.

 Bullet's normal points from body 1 to body 0 of the manifold. These are B and A or, in a
 swapped algorithm, A and B. Each point has a position on both surfaces and a signed
 distance. Points at a positive distance (up to the contact breaking threshold) belong to
 the manifold but do not touch. */
class WorldDispatch : public BulletAlgorithm {
 public:
  WorldDispatch();

  ContactAnswer Answer(const BulletPair& pair) override;
  double Separation(const BulletPair& pair) override;

 private:
  /* Runs the algorithm for `pair` and calls `read` on each resulting manifold. */
  template <typename Read>
  void Collide(const BulletPair& pair, Read read);

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
};

}  // namespace touchstone
