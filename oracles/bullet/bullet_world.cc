#include "oracles/bullet/bullet_world.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include "oracles/bullet/bullet_shape.h"

namespace touchstone {
namespace {

// Collision filter groups: static bodies do not collide with static bodies.
enum Group { kNobody = 0, kMoving = 1, kStatic = 2 };

// The flag of each value of kBulletGyroscopic.
constexpr std::array<int, 4> kGyroscopic = {0, BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT,
                                            BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD,
                                            BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY};

btScalar Restitution(const btCollisionObject* A, const btCollisionObject* B) {
  return std::min(A->getRestitution(), B->getRestitution());
}

btScalar Friction(const btCollisionObject* A, const btCollisionObject* B) {
  return btSqrt(A->getFriction() * B->getFriction());
}

}  // namespace

BulletWorld::BulletWorld(const World& world, const std::vector<Eigen::Vector3d>& inertias,
                         const std::vector<double>& values)
    : dt_(ToBullet(world.dt)),
      dispatcher_(&configuration_),
      world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
  // Global variables of Bullet, set to the same values by all worlds of the process.
  gCalculateCombinedRestitutionCallback = &Restitution;
  gCalculateCombinedFrictionCallback = &Friction;

  world_.setGravity(ToBullet(world.gravity_W));
  const btScalar margin = ToBullet(values[kBulletMargin]);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    Add(world.bodies[i], inertias[i], margin);
  SetUp(values);
}

void BulletWorld::SetUp(const std::vector<double>& values) {
  const auto residual = ToBullet(values[kBulletResidual]);
  btContactSolverInfo& info = world_.getSolverInfo();
  info.m_numIterations = static_cast<int>(values[kBulletIterations]);
  info.m_leastSquaresResidualThreshold = residual * residual;
  info.m_erp = ToBullet(values[kBulletErp]);
  info.m_erp2 = ToBullet(values[kBulletErp]);
  info.m_splitImpulse = values[kBulletSplitImpulse] != 0 ? 1 : 0;
  if (values[kBulletFrictionDirections] == 2)
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  info.m_restitutionVelocityThreshold = ToBullet(values[kBulletRestitutionThreshold]);
  const btScalar threshold = ToBullet(values[kBulletProcessingThreshold]);
  const bool sleeps = values[kBulletSleeping] != 0;
  for (const auto& body : bodies_) {
    body->setContactProcessingThreshold(threshold);
    body->setCcdMotionThreshold(ToBullet(values[kBulletContinuous]));
    body->setCcdSweptSphereRadius(ToBullet(values[kBulletSweptRadius]));
    body->setRollingFriction(ToBullet(values[kBulletRollingFriction]));
    body->setSpinningFriction(ToBullet(values[kBulletSpinningFriction]));
    body->setFlags(kGyroscopic[static_cast<std::size_t>(values[kBulletGyroscopic])]);
    if (!sleeps) body->setActivationState(DISABLE_DEACTIVATION);
  }
}

void BulletWorld::Add(const RigidBody& body, const Eigen::Vector3d& inertia,
                      btScalar margin) {
  shapes_.push_back(ToBullet(body.placed.shape, margin));
  btRigidBody::btRigidBodyConstructionInfo info(ToBullet(body.mass), nullptr,
                                                shapes_.back().get(), ToBullet(inertia));
  info.m_startWorldTransform = ToBullet(body.placed.X_WB);
  info.m_restitution = ToBullet(body.restitution);
  info.m_friction = ToBullet(body.friction);
  bodies_.push_back(std::make_unique<btRigidBody>(info));
  forces_.push_back(ToBullet(body.force_W));

  btRigidBody& added = *bodies_.back();
  added.setUserIndex(static_cast<int>(bodies_.size()) - 1);
  const bool is_static = body.mass == 0;
  if (!is_static) {
    added.setLinearVelocity(ToBullet(body.v_WB));
    added.setAngularVelocity(ToBullet(body.w_WB));
  }
  const int group = !body.collides ? kNobody : is_static ? kStatic : kMoving;
  const int meets = !body.collides ? kNobody : is_static ? kMoving : kMoving | kStatic;
  world_.addRigidBody(&added, group, meets);
}

void BulletWorld::Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W) {
  btRigidBody& pushed = *bodies_[static_cast<std::size_t>(body)];
  pushed.activate();
  pushed.applyImpulse(ToBullet(J_W), ToBullet(p_W) - pushed.getCenterOfMassPosition());
}

void BulletWorld::Step() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i]->applyCentralForce(forces_[i]);  // Bullet clears it after the step.
  }
  world_.stepSimulation(dt_, 0);  // 0: exactly one step of that length.
}

void BulletWorld::Read(WorldState& state) const {
  state.bodies.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const btRigidBody& body = *bodies_[i];
    const btQuaternion q = body.getOrientation();
    state.bodies[i] = {FromBullet(body.getCenterOfMassPosition()),
                       Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()),
                       FromBullet(body.getLinearVelocity()),
                       FromBullet(body.getAngularVelocity())};
  }
}

void BulletWorld::ReadImpulses(std::vector<ContactImpulse>& impulses) const {
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      // This contact was not solved: its impulses are those of an earlier step.
      if (point.getDistance() > manifold.getContactProcessingThreshold()) continue;
      // The impulse on body 0; the normal points into it.
      const btVector3 J_0 = point.m_appliedImpulse * point.m_normalWorldOnB +
                            point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                            point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2;
      ContactImpulse& impulse = impulses.emplace_back();
      impulse.A = manifold.getBody0()->getUserIndex();
      impulse.B = manifold.getBody1()->getUserIndex();
      impulse.p_WC = (FromBullet(point.getPositionWorldOnA()) +
                      FromBullet(point.getPositionWorldOnB())) /
                     2;
      impulse.n_AB_W = -FromBullet(point.m_normalWorldOnB);
      impulse.J_B_W = -FromBullet(J_0);
      impulse.separation = point.getDistance();
      impulse.t_W = FromBullet(point.m_lateralFrictionDir1);
    }
  }
}

}  // namespace touchstone
