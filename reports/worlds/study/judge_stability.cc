#include "reports/worlds/study/judge_stability.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/trajectory_difference.h"
#include "reports/worlds/study/world_size.h"

namespace touchstone {
namespace {

/** Returns the largest speed of a centre or of a surface in any sample. [m/s] */
double FastestOf(const World& world, const Trajectory& trajectory) {
  const double radius = LargestRadius(world);
  double fastest = 0;
  for (const WorldState& state : trajectory.samples) {
    for (const BodyState& body : state.bodies)
      fastest = std::max(fastest, body.v_WB.norm() + radius * body.w_WB.norm());
    for (const PointState& particle : state.particles)
      fastest = std::max(fastest, particle.v_W.norm());
    for (const PointState& node : state.nodes)
      fastest = std::max(fastest, node.v_W.norm());
  }
  return fastest;
}

}  // namespace

double LatenessOf(const Study& study) {
  const World& world = study.scenario.world;
  const auto moving = std::count_if(world.bodies.begin(), world.bodies.end(),
                                    [](const RigidBody& body) { return body.mass > 0; });
  const double fall = 2 * world.gravity_W.norm() * world.dt * static_cast<double>(moving);
  return 1.5 * world.dt * (FastestOf(world, study.trajectory) + fall);
}

Finding JudgeStability(const Study& study, double gain,
                       std::span<const Trajectory> nudged) {
  const World& world = study.scenario.world;
  const double radius = LargestRadius(world);
  const double until = UntilOf(study);
  // Positions move by one rounding per axis; rotations move the surfaces by as much.
  const double moved = 2 * std::sqrt(3.0) * RoundingOf(study, 1);
  const double steps = std::min<double>(world.steps, until / world.dt);
  const double late = LatenessOf(study);
  Finding finding;
  finding.scenario = study.scenario.id;
  finding.oracle = study.oracle.name;
  finding.measure = MeasureKind::kStability;
  finding.tolerance = gain * (moved + 2 * RoundingOf(study, steps)) + late;
  finding.tolerance_because = fmt::format(
      "{:.3g} × (the {:.3g} m by which the start is moved and 64 roundings a step); "
      "{:.3g} m for a contact that is detected a step late",
      gain, moved, late);
  for (const Trajectory& other : nudged) {
    const double apart = DistanceBetween(study.trajectory, other, radius, until);
    if (apart <= finding.value) continue;
    finding.value = apart;
    State(LargestDifference(world, study.trajectory, other, until), finding);
    finding.proof = fmt::format(
        "{} is up to {:.6g} m away if its start is moved by {:.3g} m, by distance + "
        "angle × radius: {}{}",
        finding.oracle, apart, moved, finding.proof, PrintedBy(other));
  }
  if (finding.value <= finding.tolerance) {
    TakeBackProof(finding);
    return finding;
  }
  finding.verdict = Verdict::kFail;
  finding.cause = Cause::kDefect;
  finding.cause_because = "the scenario claims that the motion is stable";
  return finding;
}

}  // namespace touchstone
