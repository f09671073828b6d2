#pragma once

#include <optional>

#include <Eigen/Core>

namespace cookbook {

/** What becomes of ω × (I ω), the term that lets a body without symmetry tumble. */
enum class Gyroscopic {
  kOff,  ///< Left out: ω stays, angular momentum does not.
  kExplicit,
  kImplicit,  ///< One Newton step of the implicit equation in the body frame.
  /** The angular momentum is kept to rounding and the orientation follows it by a
   fourth-order Runge–Kutta–Munthe-Kaas step. */
  kExact,
};

/** What removes overlap. */
enum class Stabilisation {
  kNone,
  /** A velocity that removes a share of the excess depth per step. */
  kBaumgarte,
  /** A spring with a damper instead of a hard contact. */
  kSoft,
  /** The book's: the deepest contact of a pair translates both bodies. */
  kLinearProjection,
  /** Bodies are moved and turned, velocities are left alone. */
  kNonLinearProjection,
};

/** How a world is stepped. Every refinement can be switched on its own;
 docs/decisions/0030-a-step-of-the-world.md says what each default was measured to buy. */
struct Settings {
  Eigen::Vector3d gravity_W{0, -9.82, 0};  ///< [m/s²]

  Gyroscopic gyroscopic = Gyroscopic::kExact;

  /** Sweeps over all contacts and joints that a step may always use. A large world, see
   IsSmall(), takes an eighth less of them, over-relaxed. */
  int impulse_iterations = 8;
  /** A small world may use more sweeps, until it is solved: as long as sweeps × rows stay
   below this on the average. A step may use up to 20 times as many more, which others
   save, before it or after: new contacts have no impulses to start from. */
  int iteration_budget = 4000;
  /** A step is solved where no sweep changes a relative velocity by more than this share
   of the greatest there is. */
  double residual = 1e-14;
  /** Rounds in which rods and springs, which are not linear in the impulses, are solved.
   */
  int joint_rounds = 12;
  /** Takes a step of a world with rods or springs as five where nothing touches: of
   fourth order in time, not of second. */
  bool fourth_order_joints = true;
  /** Solves the contacts of a large world, see IsSmall(), in single precision: what its
   few sweeps leave is more by far than what this rounds, and no `residual` ends them. Not
   where a body has a mass beyond 1e±6 kg, is so slim that its moments of inertia differ a
   thousandfold, or turns a thousand times easier than it moves (r² / I by 1/m). */
  bool single_precision = true;
  /** Brings islands of a small world to rest at once, where they can be, see
   * StaticEquilibrium. */
  bool static_equilibrium = true;
  /** Starts from the impulses of the step before. */
  bool warm_starting = true;
  /** Clamps the sum of the impulses of a contact, not every single one. */
  bool accumulated_impulses = true;
  /** Approach below which contacts do not bounce, in multiples of what gravity and forces
   add in a step, see ExternalLoads: slower bounces last less than two steps. */
  double resting_speed = 1;
  /** Lets what flies strike at the moment it meets something, not at the start of the
   step that finds it inside. */
  bool continuous_collision = true;

  Stabilisation stabilisation = Stabilisation::kNonLinearProjection;
  /** Share of the excess depth removed per step, in (0, 1]. A large world, see IsSmall(),
   removes a fifth at most. */
  double position_correction_fraction = 0.45;
  /** Depth that is left, against jitter. Absent: as `speculative_margin`. [m] */
  std::optional<double> penetration_slop;
  int position_iterations = 4;
  /** Contacts apart by less are kept ready, so that rounding does not take a corner from
   a box at rest. Absent: 2 a dt², the way that the load a on what rests would make of two
   steps; under gravity alone a = |g|. Of what forces and springs load see ExternalLoads.
   [m] */
  std::optional<double> speculative_margin;
  /** Of Stabilisation::kSoft. The frequency is at most 1/(8 dt). [Hz] */
  double soft_frequency = 30;
  double soft_damping_ratio = 10;

  /** Threads that share a step, the caller's included. The bits do not depend on it. */
  int threads = 1;

  /** How long all bodies of an island have to be slow before it sleeps, see Sleep.
   More than 0; absent: nothing sleeps. [s] */
  std::optional<double> sleep_after;
  /** What is slow: |v| + radius |ω| below this. [m/s] */
  double sleep_speed = 0.05;

  /** Every step is taken as so many shorter ones. */
  int sub_steps = 1;
};

/** Whether a world of so many contacts may be swept more often than any world, see
 Settings::iteration_budget. What is so small is solved; what is large is off by more,
 keeps of a face no more than four contacts, see ReduceManifold(). It stays large until it
 has half as many. */
bool IsSmall(const Settings& settings, int contacts);

/** Refuses settings that make no sense.
 @throws std::invalid_argument with a sentence that names the setting. */
void Validate(const Settings& settings);

}  // namespace cookbook
