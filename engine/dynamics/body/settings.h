#pragma once

#include <optional>

#include <Eigen/Core>

namespace cookbook {

/** How the gyroscopic term ω × (I ω), which makes an asymmetric body tumble, is treated.
 */
enum class Gyroscopic {
  kOff,  ///< Left out: ω is conserved, angular momentum is not.
  kExplicit,
  kImplicit,  ///< One Newton step of the implicit equation in the body frame.
  /** Angular momentum is conserved to rounding, and the orientation is integrated from it
   by a fourth-order Runge–Kutta–Munthe-Kaas step. */
  kExact,
};

/** How penetration is removed. */
enum class Stabilisation {
  kNone,
  /** A velocity bias that removes a fraction of the excess depth per step. */
  kBaumgarte,
  /** Soft contacts: a spring-damper instead of a hard constraint. */
  kSoft,
  /** Position correction as in the book: the deepest contact of a pair translates both
   bodies. Velocities do not change. */
  kDeepestContact,
  /** Split impulse: projected Gauss-Seidel on pseudo-velocities, with the contacts found
   at the start of the step. It translates and rotates bodies once and is then forgotten:
   linear velocities do not change. If a body has unequal moments of inertia, its angular
   velocity is scaled, because the same angular velocity has another kinetic energy at the
   new orientation. No body gains kinetic energy. */
  kSplitImpulse,
};

/** The settings of a world. Every refinement has its own switch.
 docs/decisions/0031-defaults-are-measured.md has the measured benefit of each default. */
struct Settings {
  Eigen::Vector3d gravity_W{0, -9.82, 0};  ///< [m/s²]

  Gyroscopic gyroscopic = Gyroscopic::kExact;

  /** Number of solver iterations over all contacts and joints in every step, unless they
   converge earlier. Normal impulses of contacts are over-relaxed in all of them except
   the last. More iterations may follow, see `iteration_budget`. */
  int impulse_iterations = 10;
  /** Iterations × constraints of a step, on average. The part that
   `impulse_iterations` do not use is spent on islands that have not converged yet. A
   single step may spend 30 times as much more if steps before or after it spend less: new
   contacts have no impulses for warm starting. The number of iterations falls with the
   number of constraints, by one at a time, to `impulse_iterations`; islands share the
   budget. */
  int iteration_budget = 4000;
  /** Convergence threshold: the greatest change of a relative velocity in an iteration,
   divided by the greatest relative velocity. */
  double residual = 1e-14;
  /** Number of rounds of relinearization of distance joints and springs, which are not
   linear in the impulses. */
  int joint_rounds = 12;
  /** Takes each step of a world with distance joints or springs as five sub-steps if
   there are no contacts: fourth order in time instead of second. */
  bool fourth_order_joints = true;
  /** Solves contacts in single precision in a step whose budget is too small for more
   than `impulse_iterations`. This changes the result by rounding only, about 1e-6 of the
   change of a velocity; the error that the iterations leave is far greater. Iterations
   until convergence need double precision. It is also used if a body has a mass beyond
   1e±6 kg, moments of inertia that differ by a factor of 1000, or r² / I greater than
   1000/m. */
  bool single_precision = true;
  /** Brings islands that have not converged after `impulse_iterations` to rest directly
   if they can be at rest and the budget allows another iteration, see StaticEquilibrium.
 */
  bool static_equilibrium = true;
  /** Keeps at most four contact points of two boxes, see ReduceManifold(). */
  bool reduce_manifolds = true;
  /** Starts the solver from the impulses of the previous step. */
  bool warm_starting = true;
  /** Clamps the accumulated impulse of a contact, not each increment. */
  bool accumulated_impulses = true;
  /** Approach speed below which contacts do not bounce, in multiples of the threshold in
   ExternalLoads. For a body on a floor under gravity g that threshold is 2 g h, with the
   sub-step h. A bounce from a lower speed lasts less than 4 h. [-] */
  double restitution_threshold_factor = 1;
  /** A contact at rest yields when its load deviates from its mean: a spring of stiffness
   (2π f)² m, with the effective mass m of the contact, in parallel to a damper. It takes
   the energy of piles that rock; under a constant load the contact is rigid. Greater than
   0; infinite: contacts are always rigid. Not used with Stabilisation::kSoft, for
   impacts, or without warm starting. [Hz]
   docs/decisions/0050-contacts-yield-under-varying-loads.md
   docs/decisions/0079-springs-of-contacts-keep-their-sag.md */
  double contact_frequency = 110;
  /** Retardation time of that spring and damper: stiffness × this is the damping. > 0 [s]
   */
  double contact_retardation = 0.6;
  /** Continuous collision: bodies in free flight collide at their time of impact, not at
   the start of the step that finds them in penetration. */
  bool continuous_collision = true;

  Stabilisation stabilisation = Stabilisation::kSplitImpulse;
  /** Fraction of the excess depth that is removed per step, in (0, 1]. A few iterations
   lift one body before the bodies on it. A body that is lifted off another by more than
   the speculative margin loses the contacts, and with them the impulses for warm
   starting: all that rests on it sinks in. At 0.45, a pile of 30 layers was 96 mm deep.
 */
  double position_correction_fraction = 0.2;
  /** Depth that position correction leaves, against jitter; a contact that yields keeps
   the sag of its spring under its mean load as well. Absent: the automatic
   speculative margin, even if `speculative_margin` is set. [m] */
  std::optional<double> penetration_slop;
  int position_iterations = 3;
  /** Separation below which speculative contacts are kept, so that rounding does not take
   a corner from a box at rest. Absent: automatic, 2 a h², with the sub-step h: the
   distance that a body at rest would travel in two sub-steps under its load a. With
   gravity alone a = |g|. With forces and springs the automatic margin is at most
   2 |g| h² or InnerRadius() / 50, whichever is greater, see ExternalLoads. [m] */
  std::optional<double> speculative_margin;
  /** Frequency for Stabilisation::kSoft, at most 1/(8 h) with the sub-step h. [Hz] */
  double soft_frequency = 30;
  double soft_damping_ratio = 10;  ///< For Stabilisation::kSoft.

  /** Number of threads of a step, including the caller. The result has the same bits for
   any number. */
  int threads = 1;

  /** Time for which all bodies of an island must be slow before it sleeps, see Sleep. >
   0; absent: no sleep. [s] */
  std::optional<double> sleep_after;
  /** A body is slow if |v| + radius |ω| is below this. [m/s] */
  double sleep_speed = 0.05;

  /** Number of sub-steps of each step. */
  int sub_steps = 1;
};

/** Checks that all settings are in their range.
 @throws std::invalid_argument with a sentence that names the setting. */
void Validate(const Settings& settings);

}  // namespace cookbook
