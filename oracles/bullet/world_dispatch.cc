#include "oracles/bullet/world_dispatch.h"

#include <limits>

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

namespace touchstone {
namespace {

/* Reserves memory for one pair at a time; Bullet's default reserves it for 4096. */
btDefaultCollisionConstructionInfo OnePair() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 1;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 1;
  return info;
}

}  // namespace

WorldDispatch::WorldDispatch()
    : configuration_(OnePair()), dispatcher_(&configuration_) {}

template <typename Read>
void WorldDispatch::Collide(const BulletPair& pair, Read read) {
  const btCollisionObjectWrapper A(nullptr, pair.A.shape(), pair.A.object(),
                                   pair.A.X_WB(), -1, -1);
  const btCollisionObjectWrapper B(nullptr, pair.B.shape(), pair.B.object(),
                                   pair.B.X_WB(), -1, -1);
  btCollisionAlgorithm* algorithm =
      dispatcher_.findAlgorithm(&A, &B, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  btManifoldResult result(&A, &B);
  algorithm->processCollision(&A, &B, btDispatcherInfo(), &result);
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    read(*dispatcher_.getManifoldByIndexInternal(i));
  }
  // btCollisionDispatcher calls the destructor itself, too: its pool hands out raw
  // memory.
  algorithm->~btCollisionAlgorithm();
  dispatcher_.freeCollisionAlgorithm(algorithm);
}

ContactAnswer WorldDispatch::Answer(const BulletPair& pair) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  Collide(pair, [&](const btPersistentManifold& manifold) {
    const double sign = manifold.getBody0() == pair.A.object() ? -1 : 1;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
      const btManifoldPoint& point = manifold.getContactPoint(i);
      const Eigen::Vector3d p_WC = (FromBullet(point.getPositionWorldOnA()) +
                                    FromBullet(point.getPositionWorldOnB())) /
                                   2;
      const Eigen::Vector3d n_AB_W = sign * FromBullet(point.m_normalWorldOnB);
      answer.points.push_back({p_WC, point.getDistance(), n_AB_W});
    }
  });
  if (answer.points.empty()) return answer;

  const ContactPoint* deepest = &answer.points.front();
  for (const ContactPoint& point : answer.points) {
    if (point.separation < deepest->separation) deepest = &point;
  }
  answer.touching = deepest->separation <= 0;
  answer.separation = deepest->separation;
  answer.n_AB_W = deepest->n_AB_W;
  if (!answer.touching) answer.points.clear();
  for (ContactPoint& point : answer.points) {
    if (*point.n_AB_W == *answer.n_AB_W) point.n_AB_W.reset();
  }
  return answer;
}

double WorldDispatch::Separation(const BulletPair& pair) {
  double separation = std::numeric_limits<double>::quiet_NaN();
  Collide(pair, [&](const btPersistentManifold& manifold) {
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
      const double distance = manifold.getContactPoint(i).getDistance();
      if (!(separation <= distance)) separation = distance;
    }
  });
  return separation;
}

}  // namespace touchstone
