#include "reports/worlds/study/curves.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/laws.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** The body, particle or cloth node whose position is drawn. */
struct Watched {
  std::string name;
  std::function<Eigen::Vector3d(const WorldState&)> place;
};

Watched WatchedOf(const World& world, const Claim& claim) {
  const Subjects subjects = SubjectsOf(world, claim);
  if (!subjects.bodies.empty()) {
    const auto i = static_cast<std::size_t>(subjects.bodies.front());
    return {world.bodies[i].name,
            [i](const WorldState& state) { return state.bodies[i].p_WB; }};
  }
  if (!subjects.particles.empty()) {
    const auto i = static_cast<std::size_t>(subjects.particles.front());
    return {world.particles[i].name,
            [i](const WorldState& state) { return state.particles[i].p_W; }};
  }
  if (!subjects.cloths.empty()) {
    // The node in the middle moves farthest if the cloth is held at its edge.
    const int cloth = subjects.cloths.front();
    const Cloth& of_world = world.cloths[static_cast<std::size_t>(cloth)];
    const int half = of_world.n / 2;
    const int middle = FirstNodeOf(world, cloth) + of_world.n * half + half;
    const auto i = static_cast<std::size_t>(middle);
    return {of_world.name, [i](const WorldState& state) { return state.nodes[i].p_W; }};
  }
  return {};
}

Curve CurveOf(const Trajectory& trajectory,
              const std::function<double(const WorldState&)>& value) {
  Curve curve;
  curve.times.assign(
      trajectory.times.begin(),
      trajectory.times.begin() + static_cast<std::ptrdiff_t>(trajectory.samples.size()));
  for (const WorldState& state : trajectory.samples) curve.values.push_back(value(state));
  return curve;
}

std::vector<Curve> CurvesOfAll(const WorldResult& world,
                               const std::function<double(const WorldState&)>& value) {
  std::vector<Curve> curves;
  for (const Trajectory& trajectory : world.trajectories)
    curves.push_back(CurveOf(trajectory, value));
  return curves;
}

int AxisOfLargestExtent(const Trajectory& trajectory, const Watched& watched) {
  Eigen::Vector3d lo = Eigen::Vector3d::Constant(HUGE_VAL);
  Eigen::Vector3d hi = -lo;
  for (const WorldState& state : trajectory.samples) {
    lo = lo.cwiseMin(watched.place(state));
    hi = hi.cwiseMax(watched.place(state));
  }
  int axis = 1;  // The height, if nothing moves.
  const double extent = (hi - lo).maxCoeff(&axis);
  return extent > 0 ? axis : 1;
}

const Trajectory* FirstMotion(const WorldResult& world) {
  const auto found = std::find_if(world.trajectories.begin(), world.trajectories.end(),
                                  [](const Trajectory& t) { return !t.samples.empty(); });
  return found == world.trajectories.end() ? nullptr : &*found;
}

/** Returns the first claim whose law has a closed form of the position; else the first
 claim; else a claim about everything. */
Claim ClaimWithPlace(const WorldScenario& scenario) {
  for (const Claim& claim : scenario.claims) {
    const Law* law = FindLaw(claim.law);
    if (law && law->places && law->faults(scenario.world, claim).empty()) return claim;
  }
  return scenario.claims.empty() ? Claim{} : scenario.claims.front();
}

bool Claims(const WorldScenario& scenario, std::string_view law) {
  return std::any_of(scenario.claims.begin(), scenario.claims.end(),
                     [&](const Claim& claim) { return claim.law == law; });
}

std::optional<Curve> Constant(const Trajectory& trajectory, double value) {
  return Curve{
      {trajectory.times.front(), trajectory.times[trajectory.samples.size() - 1]},
      {value, value}};
}

CurveSet PlaceOf(const WorldResult& world, const Trajectory& motion) {
  const WorldScenario& scenario = world.scenario;
  const Claim claim = ClaimWithPlace(scenario);
  const Watched watched = WatchedOf(scenario.world, claim);
  if (!watched.place) return {"", "", MeasureKind::kPositionError, {}, std::nullopt};
  const int axis = AxisOfLargestExtent(motion, watched);
  CurveSet set{
      fmt::format("{} of {}", "xyz"[axis], watched.name), "m",
      MeasureKind::kPositionError,
      CurvesOfAll(world, [&](const WorldState& s) { return watched.place(s)[axis]; }),
      std::nullopt};
  const Law* law = FindLaw(claim.law);
  if (!law || !law->places) return set;
  Curve truth;
  truth.times.assign(
      motion.times.begin(),
      motion.times.begin() + static_cast<std::ptrdiff_t>(motion.samples.size()));
  for (const Eigen::Vector3d& place : law->places(scenario.world, claim, truth.times))
    truth.values.push_back(place[axis]);
  truth.times.resize(truth.values.size());
  set.truth = truth;
  return set;
}

/** Returns how far the thing is from its closed form, whatever the direction: most faults
 are too small to be seen beside the motion, and often across it. Nothing without a closed
 form. */
std::optional<CurveSet> ErrorOfPlace(const WorldResult& world) {
  const WorldScenario& scenario = world.scenario;
  const Claim claim = ClaimWithPlace(scenario);
  const Watched watched = WatchedOf(scenario.world, claim);
  const Law* law = FindLaw(claim.law);
  if (!watched.place || !law || !law->places) return std::nullopt;
  CurveSet set{fmt::format("position error of {}", watched.name), "m",
               MeasureKind::kPositionError,
               CurvesOfAll(world, [](const WorldState&) { return 0.0; }), std::nullopt};
  std::vector<double> times;
  std::vector<Eigen::Vector3d> truths;
  for (std::size_t o = 0; o < set.of_oracle.size(); ++o) {
    Curve& curve = set.of_oracle[o];
    // Oracles are asked for the same samples; one that diverges has fewer.
    if (curve.times.size() > times.size() ||
        !std::equal(curve.times.begin(), curve.times.end(), times.begin())) {
      times = curve.times;
      truths = law->places(scenario.world, claim, times);
    }
    // A law may predict less than the whole motion.
    const std::size_t predicted = std::min(curve.values.size(), truths.size());
    curve.times.resize(predicted);
    curve.values.resize(predicted);
    for (std::size_t s = 0; s < predicted; ++s) {
      curve.values[s] =
          (watched.place(world.trajectories[o].samples[s]) - truths[s]).norm();
    }
  }
  if (truths.empty()) return std::nullopt;
  set.truth = Curve{{times.front(), times[truths.size() - 1]}, {0, 0}};
  return set;
}

}  // namespace

std::vector<CurveSet> CurvesOf(const WorldResult& result) {
  const Trajectory* motion = FirstMotion(result);
  if (!motion) return {};
  const World& world = result.scenario.world;
  std::vector<CurveSet> sets;
  CurveSet place = PlaceOf(result, *motion);
  if (!place.of_oracle.empty()) sets.push_back(std::move(place));
  if (std::optional<CurveSet> error = ErrorOfPlace(result))
    sets.push_back(std::move(*error));
  const Subjects all = SubjectsOf(world, {});
  const auto energy = [&](const WorldState& s) {
    return EnergyOf(world, s, all).total();
  };
  const auto momentum = [&](const WorldState& s) {
    return MomentumOf(world, s, all).norm();
  };
  const WorldState start = StateAtStart(world);
  sets.push_back({"energy", "J", MeasureKind::kEnergyDrift, CurvesOfAll(result, energy),
                  std::nullopt});
  if (Claims(result.scenario, "conserves_energy"))
    sets.back().truth = Constant(*motion, energy(start));
  sets.push_back({"momentum", "N s", MeasureKind::kMomentumDrift,
                  CurvesOfAll(result, momentum), std::nullopt});
  if (Claims(result.scenario, "conserves_momentum") && world.gravity_W.isZero(0))
    sets.back().truth = Constant(*motion, momentum(start));
  return sets;
}

}  // namespace touchstone
