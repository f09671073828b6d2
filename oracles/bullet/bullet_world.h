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

/** A world that Bullet steps. What is set in it, and why, is listed by
 BulletWorldSettings() (bullet_oracle_info.h). */
class BulletWorld {
 public:
  /** `inertias` are the principal moments of each body (InertiaOf). [kg m²]
   @pre No particles, springs, joints, cloths; no half-space moves. */
  BulletWorld(const World& world, const std::vector<Eigen::Vector3d>& inertias,
              BulletConstraints constraints);

  // The functions of Simulation, of the same meaning.
  void Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W);
  void Step();
  void Read(WorldState& state) const;
  void ReadImpulses(std::vector<ContactImpulse>& impulses) const;

 private:
  void MakeRigid();
  void Add(const RigidBody& body, const Eigen::Vector3d& inertia);

  btScalar dt_;
  std::vector<btVector3> forces_;  // On each body, beside gravity.
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;  // Last: it lets go of the bodies when it goes.
};

}  // namespace touchstone
