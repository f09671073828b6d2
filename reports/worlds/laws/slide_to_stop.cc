#include "reports/worlds/laws/slide_to_stop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/at_sample.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/flat_box.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/slop.h"
#include "reports/worlds/law_support/subjects.h"

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

std::vector<Worst> JudgeBy(const PlacedCone& cone, const Motion& motion, int index) {
  const World& world = motion.world;
  const double h = world.dt;
  const auto i = static_cast<std::size_t>(index);
  const RigidBody& body = world.bodies[i];
  const OnPlane on = OnPlaneOf(motion, index);
  const double brake = on.plane.friction * on.press;
  const double v_0 = on.v_along_W.norm();
  const double stop = v_0 / brake;
  Worst position(MeasureKind::kPositionError,
                 WithSlop("1.5 × (½ h (v₀ − v) and the settling distance), 1e-5 of the "
                          "distance for the solver, and 64 roundings per step",
                          motion.oracle));
  Worst friction(
      MeasureKind::kFriction,
      "1.5 × h/t of the step in which friction begins, 1e-5 of the velocity for the "
      "solver, and 64 roundings per step");
  FlatBox flat(motion, index, on);
  const std::string braked =
      fmt::format("braked by μ g = {:.6g} m/s² it slides to", brake);
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    const BodyState& is = motion.trajectory.samples[s].bodies[i];
    const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
    const Slip slip =
        SlipAfter(cone.cone, cone.frame.transpose() * on.v_along_W, brake, t);
    const Eigen::Vector3d p_W = body.placed.X_WB.p_WB + cone.frame * slip.travelled;
    const double slowed = (on.v_along_W - cone.frame * slip.velocity).norm();
    AtSample{motion, s, body.name}.Compare(
        position, is.p_WB, p_W,
        kSafety * (slowed * h / 2 + brake * h * h + on.Settling(h)) +
            kSolverResidual * v_0 * std::min(t, stop) +
            rounding * (body.placed.X_WB.p_WB.norm() + v_0 * t),
        braked);
    flat.Take(s, v_0);
    // Between a quarter and three quarters of the time to stop: v has dropped, and the
    // box still slides.
    if (t < stop / 4 || t > stop * 3 / 4) continue;
    const Eigen::Vector3d heading = on.v_along_W / v_0;
    const double lost = v_0 - (cone.frame * slip.velocity).dot(heading);
    const double mu = on.plane.friction * (v_0 - is.v_WB.dot(heading)) / lost;
    friction.Take(
        std::abs(mu - on.plane.friction),
        on.plane.friction * (kSafety * h / t + (kSolverResidual + rounding) * v_0 / lost),
        [&] {
          return Citing(
              "{} has {} slowed from {:.6g} to {:.6g} m/s after {:.6g} s: μ = {:.6g}; "
              "√(μ_A μ_B) is {:.6g}",
              motion.oracle.name, CitedName{body.name}, v_0, is.v_WB.dot(heading),
              CitedTime{t}, mu, on.plane.friction);
        });
  }
  return {position, friction, flat.orientation(), flat.spin()};
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgedByCone(motion, SubjectsOf(motion.world, claim).bodies, JudgeBy);
}

constexpr std::array<std::string_view, 2> kNumbers = {"expected_distance",
                                                      "expected_time"};

}  // namespace

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
