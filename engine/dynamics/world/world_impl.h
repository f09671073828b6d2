#pragma once

#include <atomic>
#include <vector>

#include "engine/dynamics/contacts/contact_cache.h"
#include "engine/dynamics/contacts/seams.h"
#include "engine/dynamics/impacts/impact_solver.h"
#include "engine/dynamics/joints/direct_joint_solver.h"
#include "engine/dynamics/joints/joint_solver.h"
#include "engine/dynamics/joints/rod_projection.h"
#include "engine/dynamics/joints/spring_solver.h"
#include "engine/dynamics/solver/contact_solver.h"
#include "engine/dynamics/solver/iteration_budget.h"
#include "engine/dynamics/world/contact_work_limit.h"
#include "engine/dynamics/world/external_loads.h"
#include "engine/dynamics/world/linkage_impact.h"
#include "engine/dynamics/world/linked_islands.h"
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
  /** Takes a step of `h`, which is the original one halved `halvings` times. Takes two of
   half of that if its joints cannot be solved, or if linked bodies get into each other.
 */
  void StepOnce(double h, int halvings);
  /** Returns whether a pair with a linked body is deeper after the step than before, by
   more than the speculative margin. This is the continuous collision of linked bodies. */
  bool HasMissedImpact() const;
  /** Takes the last step back: restores saved_bodies_. */
  void RestoreBodies(double h);
  /** Adds the contacts of the last part of a step to earlier_contacts_. */
  void KeepContacts();
  /** Takes one step of fourth order. If anything touches on the way, or the joints cannot
   be solved, restores the state before the step. Returns whether the step was taken. */
  bool StepFourthOrder(double h);
  /** Returns whether `counts(A, B, distance, gap)` is true for a near pair for which
   `takes(A, B)` is. In `h` [s] the two travel at most `distance` [m] towards each other,
   unless joints, springs or contacts accelerate them; `gap`: see
   ContactCache::ForEachGap(). */
  template <class Takes, class Counts>
  bool AnyApproach(double h, const Takes& takes, const Counts& counts);
  /** Returns whether two bodies, static or without joints and springs, get so close in
   `h` [s] that they may have an impact. */
  bool MayHaveImpact(double h);
  /** Returns whether a body with a joint or spring may get so deep into another in `h`
   [s] that collision detection would find the wrong side. */
  bool LinkedBodyMayPassThrough(double h);
  /** The stages of a step after contact detection, with or without continuous collision.
   Returns false, and leaves the bodies as they are, if the joints cannot be solved. */
  bool Advance(double h, bool with_impacts);
  /** Updates the load accelerations and the margins of the bodies. */
  void UpdateLoads();
  /** Updates the contacts. Returns whether there are any. */
  bool UpdateContacts(double h);
  void ApplyForcesTo(std::size_t i, double h);
  /** Computes the velocities at the end of the step without impulses, and initializes the
   solved velocities with them. */
  void ApplyForces(double h);
  /** Resolves the impacts of linked bodies: removes velocities along the joints that are
   due to an impact, and gives contacts their restitution. */
  void SolveLinkageImpacts(double h);
  /** Returns whether a rod changes its length faster than a step without an impact
   explains. */
  bool HasImpactAlongJoint(double h);
  /** Returns whether a contact of `pair` is closed and approaches faster than bodies at
   rest. */
  bool HasImpact(const ContactPair& pair, double h) const;
  /** Resolves the impact of a linked island: changes `solved_`. */
  void SolveLinkageImpact(std::size_t island, double h);
  /** Solves all constraints on velocities. Returns false if the joints cannot be solved.
   */
  bool Solve(double h);
  /** Solves joints and springs together with contacts: linearizes them at the end of the
   step, solves, and repeats until lengths and spring forces are consistent. If that does
   not converge, solves them directly. Returns whether they are solved. */
  bool SolveJoints(double h);
  /** Sets `given_`, and the solved velocities of bodies without joints and springs, from
   the impulses of the contacts. The velocities of the iterations have the rounding errors
   of all their changes, which may have been great. */
  void SumContactImpulses();
  /** Solves joints and springs by Newton's method, in turns with the contacts. */
  bool SolveJointsDirectly(double h);
  /** Reduces the contact impulses of linked islands that would add energy, see
   ContactWorkLimit, and solves their joints again. Returns whether they are solved. */
  bool LimitContactWork(double h);
  /** Ends a solve of joints that failed. In a step that cannot be halved again takes the
   last resort, and returns true. */
  bool EndWithoutSolution(double h);
  /** The last resort in a step that cannot be halved again: joints and contacts act by
   impulses at the start of the step, see LinkageImpact, which takes kinetic energy. The
   lengths get an error of second order in the step, which position correction removes. */
  void SolveJointsInelastically(double h);
  /** Computes `predicted_` from the solved velocities. */
  void PredictLinkedBodies(double h);
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
  /** Whether a body moves and has a joint or spring. */
  bool IsLinked(int body) const {
    const auto i = static_cast<std::size_t>(body);
    return linked_[i] && !bodies_[i].is_static();
  }
  bool IsInLinkedIsland(std::size_t i) const {
    return HasJoints() && linked_islands_.Contains(i);
  }
  void ExpectTwoEnds(const Anchor& A, const Anchor& B, const char* what);
  void MarkLinked(const Anchor& A, const Anchor& B);

  Settings settings_;
  std::atomic<bool> diverged_ = false;
  std::vector<RigidBody> bodies_;
  ThreadPool pool_;
  ContactCache contact_cache_;
  Seams seams_;
  int static_boxes_ = 0;  ///< Number of static boxes that collide.
  Sleep sleep_;
  std::vector<DistanceJoint> joints_;
  std::vector<Spring> springs_;
  std::vector<int> static_colliders_;  ///< Static bodies that points collide with.
  ContactSolver contact_solver_;
  LinkedIslands linked_islands_;
  ContactSolver linked_contact_solver_{1};  ///< Solves the pairs of linked islands.
  RodProjection rod_projection_;
  LinkageImpact linkage_impact_;
  /** Contacts of this sub-step that contact_cache_ and impact_solver_ do not hold: of the
   impacts of linked islands, and of earlier parts of a step that was halved. */
  std::vector<ContactPair> earlier_contacts_;
  ContactWorkLimit contact_work_limit_;
  ImpactSolver impact_solver_;
  ExternalLoads loads_;
  bool has_constant_forces_ = false;  ///< Whether any body has a constant force.
  bool has_applied_forces_ = false;   ///< Whether any body has a force for this step.
  bool fit_single_precision_ = true;  ///< FitsSinglePrecision() of all bodies.
  /** The step whose parts StepOnce() takes. Margins and position correction are those of
   it, however often it is halved. [s] */
  double whole_step_ = 0;
  /** Time step for which the loads are valid under gravity alone; 0: none. [s] */
  double loads_valid_for_ = 0;
  JointSolver joint_solver_;
  SpringSolver spring_solver_;
  DirectJointSolver direct_joint_solver_;
  std::vector<double> warm_impulses_;  ///< Of the joints, at the start of a solve. [N s]
  int halvings_left_ = 0;              ///< Of the parts of this sub-step, for joints.
  int impact_halvings_left_ = 0;       ///< The same, for impacts of linked bodies.
  bool must_solve_joints_ = false;     ///< Whether the step cannot be halved again.
  bool is_last_resort_ = false;        ///< See SolveJointsInelastically().
  bool has_lever_arms_ = false;        ///< Whether any joint or spring is off a centre.
  /** Whether IntegrateWithLeverArms() has succeeded since PredictLinkedBodies() began. */
  std::atomic<bool> rotations_solved_ = true;
  bool joints_solved_ = true;  ///< Whether the last solve succeeded.

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
  std::vector<Velocity> given_;   ///< Like free_, with the impulses of contacts.
  std::vector<Velocity> mean_;    ///< Velocities that move the bodies during the step.
  /** Those of bodies in linked islands as the work of contacts sees them: a body that a
   joint holds at an arm turns by the Cayley map. */
  std::vector<Velocity> work_mean_;
  std::vector<Velocity> linked_corrections_;  ///< Of linked islands, see corrections_.
  std::vector<Velocity> corrections_;  ///< Displacements stored as Velocity. [m], [rad]
  std::vector<Eigen::Matrix3d> uncorrected_;  ///< R_WB before position correction.
  std::vector<ContactFlags> contact_flags_;
  std::vector<char> static_;             ///< 1: static or asleep.
  std::vector<double> moved_fraction_;   ///< See JointSolver::Relinearize().
  std::vector<bool> linked_;             ///< Whether a joint or spring is attached.
  std::vector<bool> has_lever_arm_;      ///< Whether one is, away from the centre.
  std::vector<bool> driven_;             ///< See Sleep::PutToSleep().
  std::vector<RigidBody> predicted_;     ///< After the step; valid if linked.
  std::vector<RigidBody> saved_bodies_;  ///< Before the step, to restore it.
};

}  // namespace cookbook
