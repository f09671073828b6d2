#pragma once

#include <memory>
#include <vector>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <Eigen/Core>

#include "oracles/bullet/bullet_module.h"
#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** A world that Bullet steps. Its settings and their reasons are in OracleInfo::settings
 of BulletOracleInfo(). */
class BulletWorld {
 public:
  /** `inertias` are the principal moments of each body (InertiaOf). [kg m²] There
   is one of `values` for each BulletParameter.
   @pre There are no particles, springs, joints, cloths or moving half-spaces. */
  BulletWorld(const World& world, const std::vector<Eigen::Vector3d>& inertias,
              const std::vector<double>& values);

  // These have the same meaning as in Simulation.
  void Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W);
  void Step();
  void Read(WorldState& state) const;
  void ReadImpulses(std::vector<ContactImpulse>& impulses) const;

 private:
  void SetUp(const std::vector<double>& values);
  void Add(const RigidBody& body, const Eigen::Vector3d& inertia, btScalar margin);

  btScalar dt_;
  std::vector<btVector3> forces_;  // External forces without gravity, one per body.
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;  // Last, because its destructor uses the bodies.
};

}  // namespace touchstone
