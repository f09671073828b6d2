#include <algorithm>
#include <array>
#include <string_view>

#include "reports/worlds/law_support/ball_on_plane.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"

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
  const auto errors_at = [&](double t) {
    const Eigen::Vector3d v_W = slipping.At(t, cone).v_WB;
    const Eigen::Vector3d earlier_W = slipping.At(std::max(0.0, t - h), cone).v_WB;
    const Eigen::Vector3d later_W = slipping.At(t + h, cone).v_WB;
    // The change of velocity in the step before equals that in the step after, except
    // where slip ends.
    const double ending = t < h ? 0 : (later_W - 2 * v_W + earlier_W).norm();
    const double slowed = (on.v_along_W - v_W).norm();
    return BallErrors{speed, speed, ending,
                      slowed * h / 2 + on.plane.friction * on.press * h * h};
  };
  const BallWords words = {
      .how = "slipping until it rolls",
      .velocity =
          {.scheme = "((1 + μ) |v_n| of the sphere's own velocity along the normal, δ/r "
                     "of the velocity for a contact at depth δ, and μ g h in the step "
                     "in which slip ends)",
           .solved = "the velocity",
           .slop = true},
      .position = {.scheme = "(½ h (v₀ − v) and the settling distance)",
                   .solved = "the distance",
                   .slop = true}};
  return JudgeBall(motion, index, on, words,
                   {[&](double t) { return slipping.At(t, cone); }, errors_at});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgedByCone(motion, SubjectsOf(motion.world, claim).bodies, JudgeBy);
}

constexpr std::array<std::string_view, 2> kNumbers = {"expected_rolling_speed",
                                                      "expected_rolling_time"};

}  // namespace

/** A sphere that slips on a level plane is braked and spun by friction until it rolls.
 [m], [m/s], [rad/s]

 With inertia k m r², the slip s = v + ω × (−r n) decreases along its own direction at μ g
 (1 + 1/k), to zero at t_r = |s₀|/(μ g (1 + 1/k)); then it rolls. At all times v = v₀ + (s
 − s₀)/(1 + 1/k), since the angular momentum about the contact is conserved: the velocity
 of rolling does not depend on μ.

 The velocity is exact to the solver's residual, as on a slope (laws/incline.cc); in the
 step in which slip ends, to μ g h. Position: ½ h (v₀ − v) and the settling distance, ×
 1.5. 64 roundings per step are added. Solvers with two friction directions end the slip
 along another path with the same rolling velocity; such motions are recognised.

 About: spheres. Numbers: expected_rolling_speed, expected_rolling_time (t_r). */
constinit const Law kSlipToRoll = {
    .name = "slip_to_roll",
    .documentation =
        "A sphere that slips on a level plane is spun by friction until it rolls.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
