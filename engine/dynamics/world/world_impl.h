#pragma once

#include <atomic>
#include <vector>

#include "engine/dynamics/contacts/contact_cache.h"
#include "engine/dynamics/impacts/impact_solver.h"
#include "engine/dynamics/joints/joint_solver.h"
#include "engine/dynamics/joints/spring_solver.h"
#include "engine/dynamics/solver/contact_solver.h"
#include "engine/dynamics/solver/iteration_budget.h"
#include "engine/dynamics/world/external_loads.h"
#include "engine/dynamics/world/sleep.h"
#include "engine/dynamics/world/world.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** The data of a world and the stages of its step, see docs/dynamics.md. It is apart from
 World so that a user of the engine compiles none of the solvers' headers. */
class World::Impl {
 public:
  explicit Impl(const Settings& settings);

  // The public functions of World.
  int AddBody(const BodyDefinition& definition);
  int AddJoint(const DistanceJoint& joint);
  int AddSpring(const Spring& spring);
  void ApplyImpulse(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W);
  void ApplyForce(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& F_W);
  void Step(double dt);
  int body_count() const { return static_cast<int>(bodies_.size()); }
  const BodyState& state(int body) const {
    return bodies_[static_cast<std::size_t>(body)].state;
  }
  const Settings& settings() const { return settings_; }
  bool IsAsleep(int body) const { return sleep_.IsAsleep(body); }
  void AppendContactImpulses(std::vector<ContactImpulse>& impulses) const;
  bool diverged() const { return diverged_; }

 private:
  void StepOnce(double h);
  /** Takes one step of fourth order. If anything touches on the way, restores the state
   before the step. Returns whether the step was taken. */
  bool StepFourthOrder(double h);
  /** Whether two bodies, static or without joints and springs, get so close in `h` [s]
   that they may have an impact. */
  bool MayHaveImpact(double h);
  /** The stages of a step after contact detection, with or without continuous collision.
   */
  void Advance(double h, bool with_impacts);
  /** Updates the load accelerations of the bodies. */
  void UpdateLoads(double h);
  /** Updates the contacts. Returns whether there are any. */
  bool UpdateContacts(double h);
  void ApplyForcesTo(std::size_t i, double h);
  /** Computes the velocities at the end of the step without impulses, and initializes the
   solved velocities with them. */
  void ApplyForces(double h);
  /** Removes velocities along the joints that are due to an impact. */
  void SolveJointImpacts(double h);
  /** Solves all constraints on velocities. */
  void Solve(double h);
  /** Solves joints and springs together with contacts: linearizes them at the end of the
   step, solves, and repeats until lengths and spring forces are consistent. */
  void SolveJoints(double h);
  void SolveJointsUntilConverged();
  /** Integrates `body`, which is body `i` before the step, with the solved velocities. */
  void IntegrateBody(std::size_t i, double h, RigidBody& body);
  /** Integrates body `i` itself and checks the result; a point may hit a solid. */
  void IntegrateOne(std::size_t i, double h);
  void IntegrateAll(double h);
  /** Continuous collision of a point. Returns whether it has hit a solid. */
  bool CollidePoint(double h, const RigidBody& before, RigidBody& point);
  /** Moves bodies out of each other and joints to their lengths. Angular velocities are
   scaled so that no kinetic energy changes. */
  void CorrectPositions(double h);
  void PutToSleep(double h);

  RigidBody& Find(int body);
  /** Calls `work(i)` for all bodies, in parallel. */
  template <class Work>
  void ForEachBody(const Work& work);
  /** Calls `work(batch, travel)` for batches of the bodies for which `is_batched(i)` is
   true, and `other(i)` for the rest, in parallel. `work` fills `travel` with the Travel()
   of each body of the batch. */
  template <class Takes, class Work, class Other>
  void IntegrateInBatches(const Takes& is_batched, const Work& work, const Other& other);
  bool HasJoints() const { return !joints_.empty() || !springs_.empty(); }
  void ExpectTwoEnds(const Anchor& A, const Anchor& B, const char* what);
  void MarkLinked(const Anchor& A, const Anchor& B);

  Settings settings_;
  std::atomic<bool> diverged_ = false;
  std::vector<RigidBody> bodies_;
  ThreadPool pool_;
  ContactCache contact_cache_;
  Sleep sleep_;
  std::vector<DistanceJoint> joints_;
  std::vector<Spring> springs_;
  std::vector<int> static_colliders_;  ///< Static bodies that points collide with.
  ContactSolver contact_solver_;
  ImpactSolver impact_solver_;
  ExternalLoads loads_;
  bool has_constant_forces_ = false;  ///< Whether any body has a constant force.
  bool has_applied_forces_ = false;   ///< Whether any body has a force for this step.
  bool fit_single_precision_ = true;  ///< FitsSinglePrecision() of all bodies.
  /** Time step for which the loads are valid under gravity alone; 0: none. [s] */
  double loads_valid_for_ = 0;
  JointSolver joint_solver_;
  SpringSolver spring_solver_;

  IterationBudget iteration_budget_;  ///< For joints and springs.
  /** Greatest speed or velocity change of a linked body. [m/s] */
  double max_linked_speed_ = 0;
  std::atomic<bool> point_hit_ = false;  ///< Whether a point has hit a solid.

  // Indexed by body, valid during a step. Velocities have one more element, see
  // SolverBodies.
  std::vector<InverseInertia> inertias_;
  std::vector<Velocity> before_;  ///< At the start of the step.
  std::vector<Velocity> free_;    ///< At the end of the step, without impulses.
  std::vector<Velocity> solved_;  ///< At the end of the step.
  std::vector<Velocity> mean_;    ///< Velocities that move the bodies during the step.
  std::vector<Velocity> corrections_;  ///< Displacements stored as Velocity. [m], [rad]
  std::vector<double> rotational_energies_;  ///< Before position correction. [J]
  std::vector<ContactFlags> contact_flags_;
  std::vector<char> static_;             ///< 1: static or asleep.
  std::vector<double> moved_fraction_;   ///< See JointSolver::Relinearize().
  std::vector<bool> linked_;             ///< Whether a joint or spring is attached.
  std::vector<bool> driven_;             ///< See Sleep::PutToSleep().
  std::vector<RigidBody> predicted_;     ///< After the step; valid if linked.
  std::vector<RigidBody> saved_bodies_;  ///< Before the step, to restore it.
};

}  // namespace cookbook
