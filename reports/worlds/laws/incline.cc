#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/flat_box.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

/** Initial acceleration of a body from rest. */
struct Start {
  Eigen::Vector3d a_W;      ///< [m/s²]
  Eigen::Vector3d alpha_W;  ///< [rad/s²]
};

Start StartOf(const RigidBody& body, const OnPlane& on, const PlacedCone& cone) {
  const double brake = on.plane.friction * on.press;
  if (!std::holds_alternative<Sphere>(body.placed.shape)) {
    return {cone.frame *
                DrivenFromRest(cone.cone, cone.frame.transpose() * on.along_W, brake),
            Eigen::Vector3d::Zero()};
  }
  // Friction f at the contact: a = a_t + f, α = (−r n) × f m/I; rolling leaves no slip.
  const double r = RadiusOf(body);
  const double k = InertiaRatioOf(body);
  const Eigen::Vector3d holding_W = -on.along_W * k / (1 + k);
  const Eigen::Vector3d f_W =
      cone.frame * NearestInCone(cone.cone, cone.frame.transpose() * holding_W, brake);
  return {on.along_W + f_W, -on.plane.n_W.cross(f_W) / (k * r)};
}

std::string WhyNot(const World& world, int index) {
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!body.v_WB.isZero(0) || !body.w_WB.isZero(0)) return "does not start at rest";
  if (IsEvenSphere(body)) return "";
  if (!std::holds_alternative<Box>(body.placed.shape))
    return "is neither a box nor a sphere with equal moments of inertia";
  const OnPlane on = OnPlaneOf(world, index);
  if (Tips(body, on, std::min(on.plane.friction * on.press, on.along_W.norm())))
    return "is so tall that friction tips it";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  const OnPlane on = OnPlaneOf(world, index);
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const Start start = StartOf(body, on, ConesOn(on.plane.n_W).front());
  return {{"expected_acceleration", start.a_W.norm()}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(world, claim,
                          {.why_not = WhyNot,
                           .expected = "a flat box or a sphere at rest on a static plane",
                           .numbers = NumbersOfBody});
}

std::vector<Worst> JudgeBy(const PlacedCone& cone, const Motion& motion, int index) {
  const double h = motion.world.dt;
  const auto i = static_cast<std::size_t>(index);
  const RigidBody& body = motion.world.bodies[i];
  const OnPlane on = OnPlaneOf(motion, index);
  const double mu = on.plane.friction;
  const Start start = StartOf(body, on, cone);
  const double pull = on.along_W.norm() + mu * on.press;
  const double r = BoundingRadius(body.placed.shape);
  const bool is_box = std::holds_alternative<Box>(body.placed.shape);
  const double inside = on.Settling(h) / r;
  const auto predict = [&](std::size_t s) {
    const double t = motion.trajectory.times[s];
    const double across =
        (1 + mu) * on.SpeedAcross(motion.trajectory.samples[s].bodies[i].v_WB, h);
    const Eigen::Vector3d v_W = start.a_W * t;
    PredictedState predicted{
        .position = {{body.placed.X_WB.p_WB + v_W * (t / 2),
                      {.scheme = v_W.norm() * (h + inside * t) / 2 + on.Settling(h),
                       .solved = pull * t * t / 2,
                       .computed = body.placed.X_WB.p_WB.norm()}}},
        .velocity = {
            {v_W, {.scheme = across + inside * v_W.norm(), .solved = pull * t}}}};
    if (is_box) return predicted;
    const Eigen::Vector3d w_W = start.alpha_W * t;
    predicted.spin = {
        w_W, {.scheme = across / r + inside * w_W.norm(), .solved = pull * t / r}};
    return predicted;
  };
  const std::string here = fmt::format("on this slope with μ = {:.6g} it", mu);
  const AllowedWords of_velocity = {
      .scheme =
          "((1 + μ) |v_n| of the body's own velocity along the normal, and δ/r of "
          "the velocity for a contact at depth δ)",
      .solved = "the velocity from gravity and friction",
      .slop = true};
  const AllowedWords of_position = {.scheme = "(½ a h t and the settling distance)",
                                    .solved = "the distance from gravity and friction",
                                    .slop = true};
  std::vector<Worst> found =
      JudgePredictions(motion,
                       {.position = {of_position, here + " is at"},
                        .velocity = {of_velocity, here + " moves at"},
                        .spin = {of_velocity, here + " spins at"}},
                       {{body.name, StateOfBody(index), predict}});
  if (!is_box) return found;
  for (Worst& worst : JudgeFlatBox(motion, index, on, [&](double t) { return pull * t; }))
    found.push_back(std::move(worst));
  return found;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgedByCone(motion, SubjectsOf(motion.world, claim).bodies, JudgeBy);
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_acceleration"};

}  // namespace

/** A body that starts at rest on a slope of angle θ stays, slides or rolls. [m/s], [m],
 [rad/s]

 Box (Gazebo "FrictionDemo"): stays if μ >= tan θ, else a = g (sin θ − μ cos θ). Sphere of
 inertia k m r² (Drake inclined_plane_test): rolls with a = g sin θ/(1 + k) if μ >= tan θ
 k/(1 + k), else slips with a = g (sin θ − μ cos θ), α = μ g cos θ/(k r).

 The velocity is exact to the solver's residual: the friction impulse is μ times the
 normal impulse, and that cancels gravity's, however late the contact is detected. Two
 errors remain, × 1.5. The body's current velocity v_n along the normal contributes (1 +
 μ) |v_n|. A contact at depth δ contributes δ/r of the velocity, where δ is the settling
 distance and r the radius, or the bounding radius of a box. Position: ½ a h t and the
 settling distance, × 1.5. 64 roundings per step.

 Solvers with two friction directions hold more (box cone) or less (diamond cone) between
 their axes; bodies that move accordingly are recognised.

 About: boxes that lie flat, spheres. Numbers: expected_acceleration. */
constinit const Law kIncline = {
    .name = "incline",
    .documentation =
        "From rest on a slope, a box stays if μ >= tan θ, else "
        "slides, and never rotates; a sphere rolls or slips.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
