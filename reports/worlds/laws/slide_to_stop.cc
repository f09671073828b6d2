#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/flat_box.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

std::string WhyNot(const World& world, int index) {
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const OnPlane on = OnPlaneOf(world, index);
  if (!std::holds_alternative<Box>(body.placed.shape)) return "is no box";
  if (!on.IsLevel()) return "is not on a level plane";
  if (on.v_along_W.isZero(0) || !body.w_WB.isZero(0)) return "does not start sliding";
  if (on.plane.friction == 0) return "has no friction to stop it";
  if (Tips(body, on, on.plane.friction * on.press))
    return "is so tall that friction tips it";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  const OnPlane on = OnPlaneOf(world, index);
  const double v = on.v_along_W.norm();
  const double brake = on.plane.friction * on.press;
  return {{"expected_distance", v * v / (2 * brake)}, {"expected_time", v / brake}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(world, claim,
                          {.why_not = WhyNot,
                           .expected = "a box that slides flat on a level static plane",
                           .numbers = NumbersOfBody});
}

/** Judges the friction that the slowing shows, between a quarter and three quarters of
 the time to stop: v has dropped, and the box still slides. */
Worst JudgeFriction(const PlacedCone& cone, const Motion& motion, int index,
                    const OnPlane& on) {
  const AllowedWords words = {.scheme = "h/t of the step in which friction begins",
                              .solved = "the velocity"};
  Worst friction(MeasureKind::kFriction, words.Because(motion.oracle));
  const auto i = static_cast<std::size_t>(index);
  const double mu = on.plane.friction;
  const double v_0 = on.v_along_W.norm();
  const Eigen::Vector3d heading = on.v_along_W / v_0;
  const double stop = v_0 / (mu * on.press);
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    if (t < stop / 4 || t > stop * 3 / 4) continue;
    const Slip slip =
        SlipAfter(cone.cone, cone.frame.transpose() * on.v_along_W, mu * on.press, t);
    const double v = motion.trajectory.samples[s].bodies[i].v_WB.dot(heading);
    const double lost = v_0 - (cone.frame * slip.velocity).dot(heading);
    const double found = mu * (v_0 - v) / lost;
    const Allowed allowed = {.scheme = mu * motion.world.dt / t,
                             .solved = mu * v_0 / lost};
    friction.Take(std::abs(found - mu),
                  ToleranceOf(allowed, motion.oracle, StepsBefore(motion, s)), [&] {
                    return Citing(
                        "{} has {} slowed from {:.6g} to {:.6g} m/s after {:.6g} s: μ = "
                        "{:.6g}; √(μ_A μ_B) is {:.6g}",
                        motion.oracle.name, CitedName{motion.world.bodies[i].name}, v_0,
                        v, CitedTime{t}, found, mu);
                  });
  }
  return friction;
}

std::vector<Worst> JudgeBy(const PlacedCone& cone, const Motion& motion, int index) {
  const double h = motion.world.dt;
  const RigidBody& body = motion.world.bodies[static_cast<std::size_t>(index)];
  const OnPlane on = OnPlaneOf(motion, index);
  const double brake = on.plane.friction * on.press;
  const double v_0 = on.v_along_W.norm();
  const double stop = v_0 / brake;
  const auto predict = [&](std::size_t s) {
    const double t = motion.trajectory.times[s];
    const Slip slip =
        SlipAfter(cone.cone, cone.frame.transpose() * on.v_along_W, brake, t);
    const double slowed = (on.v_along_W - cone.frame * slip.velocity).norm();
    return PredictedState{
        .position = {{body.placed.X_WB.p_WB + cone.frame * slip.travelled,
                      {.scheme = slowed * h / 2 + brake * h * h + on.Settling(h),
                       .solved = v_0 * std::min(t, stop),
                       .computed = body.placed.X_WB.p_WB.norm()}}}};
  };
  std::vector<Worst> found = JudgePredictions(
      motion,
      {.position = {{.scheme = "(½ h (v₀ − v) and the settling distance)",
                     .solved = "the distance",
                     .slop = true},
                    fmt::format("braked by μ g = {:.6g} m/s² it slides to", brake)}},
      {{body.name, StateOfBody(index), predict}});
  found.push_back(JudgeFriction(cone, motion, index, on));
  for (Worst& worst : JudgeFlatBox(motion, index, on, [&](double) { return v_0; }))
    found.push_back(std::move(worst));
  return found;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgedByCone(motion, SubjectsOf(motion.world, claim).bodies, JudgeBy);
}

constexpr std::array<std::string_view, 2> kNumbers = {"expected_distance",
                                                      "expected_time"};

}  // namespace

/** A box that slides on a level plane stops after v/(μ g), at the distance v²/(2 μ g)
 along its heading. [m], [-]

 Chrono "sliding_gravity" (Xiang et al. 2009); heading sweep of Jolt "TestFriction".
 Semi-implicit Euler falls short by ½ μ g h t, at the end by ½ v h. The tolerance is 1.5
 times that and the settling distance (law_support/on_plane.h), the residual of iterative
 solvers (1e-5 of the velocity), and 64 roundings per step. Friction: μ = (v₀ − v)/(g t)
 at samples between a quarter and three quarters of the time to stop. Its relative
 tolerance is 1.5 h/t, for the step in which friction begins.

 Solvers with two friction directions stop elsewhere: with the box cone at (v_x², v_y²)/(2
 μ g), with the diamond at ((v_x² + v_y²)/2, v_x v_y)/(μ g) for v_x >= v_y. Such motions
 are recognised, in the frames that follow from the normal.

 About: boxes that lie flat and are low enough not to tip: μ times the height of the
 centre is less than the distance to the nearer edge. Numbers: expected_distance,
 expected_time. */
constinit const Law kSlideToStop = {
    .name = "slide_to_stop",
    .documentation =
        "A box that slides on a level plane stops after "
        "v²/(2 μ g), along its heading, and does not rotate.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
