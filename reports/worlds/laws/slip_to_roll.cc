#include "reports/worlds/laws/slip_to_roll.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "reports/worlds/law_support/ball_on_plane.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** A sphere that slips on a plane. */
struct Slipping {
  OnPlane on;
  double radius;
  double k;             ///< I/(m r²). [-]
  Eigen::Vector3d s_W;  ///< Slip at the start. [m/s]
  Eigen::Vector3d w_W;  ///< Spin at the start. [rad/s]
  Eigen::Vector3d p_W;  ///< Position at the start. [m]

  /** Returns the rate at which friction reduces the slip. [m/s²] */
  double Brake() const { return on.plane.friction * on.press * (1 + 1 / k); }

  /** Returns the motion after `t`, with friction bounded by `cone`. */
  BodyState At(double t, const PlacedCone& cone) const {
    const Slip slip = SlipAfter(cone.cone, cone.frame.transpose() * s_W, Brake(), t);
    const Eigen::Vector3d left_W = cone.frame * slip.velocity;
    const Eigen::Vector3d& n_W = on.plane.n_W;
    BodyState state;
    state.v_WB = on.v_along_W + (left_W - s_W) / (1 + 1 / k);
    state.p_WB =
        p_W + on.v_along_W * t + (cone.frame * slip.travelled - s_W * t) / (1 + 1 / k);
    // ω × (−r n) = s − v; the spin about the normal is constant.
    state.w_WB = w_W.dot(n_W) * n_W - n_W.cross(left_W - state.v_WB) / radius;
    state.q_WB.setIdentity();
    return state;
  }
};

Slipping SlippingOf(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const OnPlane on = OnPlaneOf(world, index);
  const double r = RadiusOf(body);
  return {on,
          r,
          InertiaRatioOf(body),
          on.v_along_W - r * body.w_WB.cross(on.plane.n_W),
          body.w_WB,
          body.placed.X_WB.p_WB};
}

std::string WhyNot(const World& world, int index) {
  std::string why = WhyNoBallOnPlane(world, index);
  if (!why.empty()) return why;
  const OnPlane on = OnPlaneOf(world, index);
  if (!on.IsLevel()) return "is not on a level plane";
  if (on.plane.friction == 0) return "has no friction to turn it";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  const Slipping slipping = SlippingOf(world, index);
  const double t_r = slipping.s_W.norm() / slipping.Brake();
  const BodyState rolling = slipping.At(t_r, ConesOn(slipping.on.plane.n_W).front());
  return {{"expected_rolling_speed", rolling.v_WB.norm()},
          {"expected_rolling_time", t_r}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(world, claim,
                          {.why_not = WhyNot,
                           .expected = "a sphere on a level static plane",
                           .numbers = NumbersOfBody});
}

std::vector<Worst> JudgeBy(const PlacedCone& cone, const Motion& motion, int index) {
  const double h = motion.world.dt;
  const Slipping slipping = SlippingOf(motion.world, index);
  const OnPlane on = OnPlaneOf(motion, index);
  // The largest terms of a velocity: the initial speed and that of the sphere's surface.
  const double speed = on.v_along_W.norm() + slipping.w_W.norm() * slipping.radius;
  BallOnPlane ball(
      motion, index, on, "slipping until it rolls",
      "1.5 × ((1 + μ) |v_n| of the sphere's own velocity along the normal, δ/r of the "
      "velocity for a contact at depth δ, and μ g h in the step in which slip ends), "
      "1e-5 of the velocity for the solver, and 64 roundings per step",
      "1.5 × (½ h (v₀ − v) and the settling distance), 1e-5 of the distance for the "
      "solver, and 64 roundings per step");
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    const BodyState truth = slipping.At(t, cone);
    const BodyState earlier = slipping.At(std::max(0.0, t - h), cone);
    const BodyState later = slipping.At(t + h, cone);
    // The change of velocity in the step before equals that in the step after, except
    // where slip ends.
    const double ending =
        (later.v_WB - 2 * truth.v_WB + earlier.v_WB).norm() * (t < h ? 0 : 1);
    const double slowed = (on.v_along_W - truth.v_WB).norm();
    ball.Take(
        s, truth,
        {speed, speed, ending, slowed * h / 2 + on.plane.friction * on.press * h * h});
  }
  return ball.Findings();
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgedByCone(motion, SubjectsOf(motion.world, claim).bodies, JudgeBy);
}

constexpr std::array<std::string_view, 2> kNumbers = {"expected_rolling_speed",
                                                      "expected_rolling_time"};

}  // namespace

constinit const Law kSlipToRoll = {
    .name = "slip_to_roll",
    .documentation =
        "A sphere that slips on a level plane is spun by friction until it rolls.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
