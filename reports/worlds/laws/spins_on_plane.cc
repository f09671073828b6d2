#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include <Eigen/Geometry>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/slop.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Largest sine of the angle of the spin to the normal; quaternions have 16 digits. [-]
 */
constexpr double kAlong = 1e-9;

/** The face that a body spins on. */
struct Sole {
  double rim;     ///< Distance of its farthest point from the axis. [m]
  double narrow;  ///< Distance of its nearest edge from the axis. [m]
  double height;  ///< Of the centre of mass above it. [m]

  /** Returns the largest sine of the angle by which the body leans if its edges may
   differ by twice `settling`, up on one side and down on the other. [-] */
  double LeanAt(double settling) const { return std::min(1.0, settling / narrow); }

  /** Returns the largest distance of a point of the sole from the vertical through the
   centre of mass while the body leans. [m] */
  double ReachAt(double settling) const { return rim + height * LeanAt(settling); }
};

Sole SoleOf(const RigidBody& body, const Eigen::Vector3d& n_W) {
  if (const auto* cylinder = std::get_if<Cylinder>(&body.placed.shape))
    return {cylinder->radius, cylinder->radius, cylinder->half_length};
  const Eigen::Vector3d& half = std::get<Box>(body.placed.shape).half_extents;
  const Eigen::Vector3d n_B = body.placed.X_WB.R_WB.transpose() * n_W;
  int up = 0;
  n_B.cwiseAbs().maxCoeff(&up);
  const double a = half[(up + 1) % 3];
  const double b = half[(up + 2) % 3];
  return {std::hypot(a, b), std::min(a, b), half[up]};
}

std::string WhyNot(const World& world, int index) {
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const OnPlane on = OnPlaneOf(world, index);
  const Eigen::Vector3d& n_W = on.plane.n_W;
  const bool is_cylinder = std::holds_alternative<Cylinder>(body.placed.shape);
  if (!is_cylinder && !std::holds_alternative<Box>(body.placed.shape))
    return "is neither a box nor a cylinder";
  if (is_cylinder && std::abs(body.placed.X_WB.R_WB.col(2).dot(n_W)) < 0.5)
    return "is a cylinder that does not stand on its base";
  if (!on.IsLevel()) return "is not on a level plane";
  if (!body.v_WB.isZero(0)) return "moves along the plane";
  if (!(body.w_WB.cross(n_W).norm() <= kAlong * std::abs(body.w_WB.dot(n_W))) ||
      body.w_WB.isZero(0)) {
    return "does not spin about the normal of the plane";
  }
  return "";
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(
      world, claim,
      {.why_not = WhyNot,
       .expected = "a box or a cylinder that spins flat on a level static plane",
       .numbers = [](const World&, int) { return ExpectedNumbers(); }});
}

std::vector<LawFinding> JudgeBody(const Motion& motion, int index) {
  const World& world = motion.world;
  const auto i = static_cast<std::size_t>(index);
  const RigidBody& body = world.bodies[i];
  const OnPlane on = OnPlaneOf(motion, index);
  const Eigen::Vector3d& n_W = on.plane.n_W;
  const double start = body.w_WB.dot(n_W);
  const Eigen::Vector3d axis_W = std::copysign(1.0, start) * n_W;
  const Eigen::Vector3d n_B = body.placed.X_WB.R_WB.transpose() * n_W;
  const Eigen::Vector3d moments = InertiaOf(body);
  const double inertia = n_B.cwiseAbs2().dot(moments);
  const Sole sole = SoleOf(body, n_W);
  const double settling = on.Settling(world.dt);
  // The change of the spin by a normal impulse of one unit per mass at the farthest point
  // of the sole. [1/m]
  const double reach = sole.ReachAt(settling);
  const double grip =
      std::numbers::sqrt2 * on.plane.friction * body.mass * reach / inertia;
  // Energy of the fall while it settles could turn into spin, by ½ I (ω² − ω₀²).
  const double energy =
      kSafety * body.mass * on.press * settling / (inertia * std::abs(start));
  // A body that leans by θ exchanges (I_i/I − 1) sin²θ of its spin with its angular
  // momentum; a scheme of first order errs by h ω₀ of that.
  const double wobble = kSafety * (moments.array() / inertia - 1).abs().maxCoeff() *
                        std::pow(sole.LeanAt(settling), 2) *
                        std::min(1.0, world.dt * std::abs(start)) * std::abs(start);
  const double gained = energy + wobble;
  const double lost = kSafety * grip * on.SettlingSpeed(world.dt) + wobble;
  Worst spin(
      MeasureKind::kSpinError,
      WithSlop("1.5 × what settling may give or take: the spin of its energy, or "
               "the friction of its speed at the farthest point of the sole, and the "
               "error of one step in turning a body that leans as far; 1e-5 of the spin "
               "and of what friction may take for the solver, and 64 roundings per step",
               motion.oracle));
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    const BodyState& state = motion.trajectory.samples[s].bodies[i];
    // A body that leans trades spin for moment; no normal force turns it about the
    // normal. An engine without a gyroscopic term keeps the spin.
    const Eigen::Vector3d L_W = InertiaInWorld(body, state.q_WB) * state.w_WB;
    const double by_momentum = L_W.dot(axis_W) / inertia;
    const double by_spin = state.w_WB.dot(axis_W);
    const double most = std::abs(start);
    const double least = std::max(0.0, most - grip * on.press * t);
    const auto beyond = [&](double w) { return std::max(w - most, least - w); };
    const double is = beyond(by_spin) < beyond(by_momentum) ? by_spin : by_momentum;
    const double share =
        kSolverResidual + RoundingOf(motion.oracle, StepsBefore(motion, s));
    const auto proof = [&] {
      return Citing(
          "{} has {} spinning at {:.9g} rad/s after {:.6g} s, and at {:.9g} rad/s by its "
          "angular momentum about the normal; friction leaves from {:.9g} to {:.9g} "
          "rad/s",
          motion.oracle.name, CitedName{body.name}, by_spin, CitedTime{t}, by_momentum,
          least, most);
    };
    spin.Take(std::max(is - most, 0.0), gained + share * most, proof);
    spin.Take(std::max(least - is, 0.0), lost + share * (most + (most - least)), proof);
  }
  return FindingsOf({spin});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return WorstOfEach(SubjectsOf(motion.world, claim).bodies,
                     [&](int body) { return JudgeBody(motion, body); });
}

}  // namespace

/** A body that spins on a flat sole, about the normal of a level static plane, is not
 spun up, and friction slows it no faster than at the farthest point of the sole: with the
 spin ω₀ at the start, the weight m g on the plane, the inertia I about the normal and the
 distance R of that point from the vertical through the centre of mass

   ω₀ − √2 μ m g R/I t <= ω <= ω₀, and ω >= 0 in the sense of ω₀. [rad/s]

 ω is the angular momentum about the normal, n·(R I Rᵀ ω), over I: a tall body that leans
 by a documented slop spins slower about the normal and loses nothing. Or it is the spin
 about the normal, which an engine without a gyroscopic term keeps; a motion need obey one
 of the two. Where on a flat sole a rigid body presses is not determined, so neither is
 the torque. √2 is the corner of a friction cone that is a square, the widest in use. R
 includes how far the rim moves out when the body leans by what settling allows. Without
 friction the spin is constant.

 Tolerance: what settling (law_support/on_plane.h) may give or take, the spin of its
 energy or the friction of its speed at that point; the error h ω₀ of a step in what a
 body that leans as far exchanges between spin and angular momentum, |I_i/I − 1| sin²θ ω₀;
 the residual of the solver, rounding.

 About: boxes on a face and cylinders on a base that start with a spin about the normal
 alone. Numbers: none. */
constinit const Law kSpinsOnPlane = {
    .name = "spins_on_plane",
    .documentation =
        "A box or cylinder that spins flat on a level plane is not spun up, and friction "
        "slows it no faster than at the farthest point of its sole.",
    .numbers = {},
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
