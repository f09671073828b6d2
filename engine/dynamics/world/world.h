#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "engine/dynamics/body/body.h"
#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/contacts/contact_cache.h"
#include "engine/dynamics/impacts/impact_solver.h"
#include "engine/dynamics/joints/distance_joint.h"
#include "engine/dynamics/joints/spring.h"
#include "engine/dynamics/solver/contact_solver.h"
#include "engine/dynamics/solver/iteration_budget.h"
#include "engine/dynamics/world/external_loads.h"
#include "engine/dynamics/world/sleep.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** What one contact did in a step. */
struct ContactImpulse {
  int A;
  int B;
  Eigen::Vector3d p_WC;    ///< Where it acted. [m]
  Eigen::Vector3d n_AB_W;  ///< Unit, out of A into B.
  Eigen::Vector3d J_B_W;   ///< Impulse on B; A received its opposite. [N s]
  /** At the start of the step, or at the moment of a impact: < 0 penetrating. [m] */
  double separation;
};

/** Rigid bodies in contact, stepped in time. Bodies are known by the index that AddBody()
 returned: 0, 1, 2, …

 The same calls give the same bits. Where a world has to refuse it throws
 std::invalid_argument with a sentence and stays as it was. */
class World {
 public:
  explicit World(const Settings& settings = {});

  int AddBody(const BodyDefinition& definition);

  /** Adds a rod; returns its index among the rods.
   @throws std::invalid_argument where an anchor is on no body, both are on one, a number
   is not finite, or the length is not positive. */
  int AddJoint(const DistanceJoint& joint);

  /** Adds a spring; returns its index among the springs.
   @throws std::invalid_argument as AddJoint(), and where a constant is negative. */
  int AddSpring(const Spring& spring);

  /** Applies an impulse [N s] at a world point [m] now. Static bodies take no notice. */
  void ApplyImpulse(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W);

  /** Applies a force [N] at a world point [m] during the next step: during all of it, as
   it is now. */
  void ApplyForce(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& F_W);

  /** Advances by `dt` [s], > 0. A world that has diverged stays as it is. */
  void Step(double dt);

  int body_count() const { return static_cast<int>(bodies_.size()); }
  const BodyState& state(int body) const {
    return bodies_[static_cast<std::size_t>(body)].state;
  }
  const Settings& settings() const { return settings_; }

  /** Whether a body sleeps, see Settings::sleep_after. */
  bool IsAsleep(int body) const { return sleep_.IsAsleep(body); }

  /** Appends what every touching contact did in the last step (the last sub-step). */
  void ReadImpulses(std::vector<ContactImpulse>& impulses) const;

  /** Whether a state became not finite, or larger than 1e12 in SI units. */
  bool diverged() const { return diverged_; }

 private:
  void StepOnce(double h);
  /** Takes one step of fourth order, or, where anything touches on the way, none at all,
   and returns whether it did. */
  bool StepFourthOrder(double h);
  /** Whether two that no rod or spring holds come so near in `h` [s] that a impact is to
   be looked for. */
  bool MayImpact(double h);
  void Advance(double h, bool follow_blows);
  /** Finds how hard the bodies are pulled. */
  void FindLoads(double h);
  /** Returns whether there are any contacts. */
  bool FindContacts(double h);
  void ApplyForcesTo(std::size_t i, double h);
  /** Finds how bodies would move if nothing touched them: what is solved starts there. */
  void ApplyForces(double h);
  void StopStretching(double h);
  void Solve(double h);
  void SolveJoints(double h);
  void SolveJointsUntilConverged();
  /** Moves `body`, which is body `i` as it is before the step, by the velocities solved
   so far. */
  void MoveBody(std::size_t i, double h, RigidBody& body);
  /** The same with the body itself, and what comes of it. */
  void MoveOne(std::size_t i, double h);
  void Move(double h);
  /** Returns whether the point has met a solid on its way. */
  bool MeetSolids(double h, const RigidBody& before, RigidBody& point);
  void Project(double h);
  void PutToSleep(double h);

  RigidBody& Find(int body);
  /** Calls `work(i)` for all bodies, shared by the threads: each its own. */
  template <class Work>
  void ForEachBody(const Work& work);
  /** Calls `work(bodies, ways)` for some of the bodies that `takes(i)` after the other,
   which fills `ways` with how far they have gone; `other(i)` for the rest. */
  template <class Takes, class Work, class Other>
  void ForSomeBodies(const Takes& takes, const Work& work, const Other& other);
  bool HasLinks() const { return !joints_.empty() || !springs_.empty(); }
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
  std::vector<int> solids_;  ///< What points meet.
  ContactSolver contacts_;
  ImpactSolver impacts_;
  ExternalLoads loads_;
  bool has_forces_ = false;           ///< Whether a constant force loads a body.
  bool is_pushed_ = false;            ///< Whether a force of this step loads one.
  bool fit_single_precision_ = true;  ///< Whether all bodies do.
  /** The step for which all is found, and gravity alone loads; 0: none. [s] */
  double found_for_ = 0;
  JointSolver rods_;
  SpringSolver spring_solver_;

  IterationBudget iteration_budget_;  ///< Of what sweeps over rods and springs.
  double fastest_ = 0;                ///< Of the linked bodies, or loads on them. [m/s]
  std::atomic<bool> point_hit_ = false;  ///< Whether a point has met a solid.

  // By body, while a step is taken. Velocities have one more place, see SolverBodies.
  std::vector<InverseInertia> inertias_;
  std::vector<Velocity> before_;  ///< At its start.
  std::vector<Velocity> free_;    ///< At the end of the step, without impulses.
  std::vector<Velocity> solved_;  ///< At the end of the step.
  std::vector<Velocity> mean_;    ///< What moves the body during the step.
  std::vector<Velocity> moves_;   ///< Of the projection. [m], [rad]
  std::vector<Touch> touches_;
  std::vector<char> static_;      ///< 1 where it is, or sleeps.
  std::vector<double> shares_;    ///< See JointSolver::Relinearize().
  std::vector<bool> linked_;      ///< Whether a rod or a spring holds it.
  std::vector<bool> driven_;      ///< See Sleep::PutToSleep().
  std::vector<RigidBody> ahead_;  ///< After the step; valid where linked.
  std::vector<RigidBody> kept_;   ///< As it was, should a step have to be taken back.
};

}  // namespace cookbook
