#include "reports/worlds/study/neighbours.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "reports/worlds/laws/laws.h"
#include "reports/worlds/study/body_steps.h"
#include "reports/worlds/study/run_claims.h"
#include "reports/worlds/study/world_size.h"
#include "scenarios/generators/ensemble.h"
#include "scenarios/generators/random.h"

namespace touchstone {
namespace {

/** Number of times that the start of a world is moved: by one move and by its opposite. A
 body that reaches another at the end of a step, to a rounding, is late by a step in one
 of the two. */
constexpr std::size_t kNudges = 2;

/** The same for a stable world: whether a rounding error opens a contact or closes it is
 chance. */
constexpr std::size_t kNudgesOfStable = 4;

/** Returns the world with every position moved by up to |nudge| [m] along each axis.
 Every body is also turned, by the angle that moves the surface of the largest body by as
 much: a body that spins about its middle axis amplifies rotations, not translations. The
 moves depend on `seed`; -nudge makes the opposite moves. */
World Nudged(WorldScenario scenario, double nudge, unsigned seed) {
  scenario.ensemble = Ensemble{2, nudge, seed};
  World world = MemberOf(scenario, 1);
  const double radius = LargestRadius(world);
  if (radius == 0) return world;
  Random random({seed, 2});
  for (RigidBody& body : world.bodies) {
    if (body.mass == 0) continue;
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    for (double& half_angle : turn.vec())
      half_angle = random.Uniform(-nudge, nudge) / (2 * radius);
    Pose& X_WB = body.placed.X_WB;
    X_WB = Pose::FromQuaternion(X_WB.p_WB,
                                (turn * Eigen::Quaterniond(X_WB.R_WB)).normalized());
  }
  return world;
}

/** Returns whether a claim is judged by order or limit. */
bool HasLimit(const WorldScenario& scenario) {
  return std::any_of(scenario.claims.begin(), scenario.claims.end(),
                     [](const Claim& claim) {
                       const Law* law = FindLaw(claim.law);
                       return law != nullptr && (law->smooth || law->has_impacts);
                     });
}

/** Returns the n-th copy with a moved start. */
World NudgedCopy(const WorldScenario& scenario, double nudge, std::size_t n) {
  return Nudged(scenario, n % 2 == 0 ? nudge : -nudge, static_cast<unsigned>(n / 2) + 1);
}

}  // namespace

std::vector<Trajectory> SimulateNudged(const WorldScenario& scenario,
                                       const Oracle& oracle, double nudge,
                                       std::size_t count) {
  std::vector<World> worlds;
  worlds.reserve(count);
  for (std::size_t n = 0; n < count; ++n)
    worlds.push_back(NudgedCopy(scenario, nudge, n));
  return oracle.SimulateEach(worlds);
}

Neighbours SimulateNeighbours(const WorldScenario& scenario, const Oracle& oracle,
                              double nudge, const WantedNeighbours& wanted) {
  std::vector<World> worlds;
  std::vector<Trajectory*> places;
  const auto ask = [&](World world, Trajectory& place) {
    worlds.push_back(std::move(world));
    places.push_back(&place);
  };
  Neighbours motions;
  if (IsStudied(scenario)) {
    for (WorldVariant& variant : VariantsOf(scenario.world)) {
      if (!wanted.variant || wanted.variant(variant.measure))
        motions.variants.push_back({std::move(variant), {}});
    }
    if (wanted.limit || wanted.causes || !motions.variants.empty())
      ask(Refined(scenario.world, 2), motions.half);
    if (wanted.limit && HasLimit(scenario))
      ask(Refined(scenario.world, 4), motions.quarter.emplace());
    motions.nudged.resize(FindClaim(scenario, kStable) ? kNudgesOfStable : kNudges);
    for (std::size_t n = 0; n < motions.nudged.size(); ++n)
      ask(NudgedCopy(scenario, nudge, n), motions.nudged[n]);
    for (VariantMotion& motion : motions.variants)
      ask(motion.variant.world, motion.trajectory);
  }
  if (FindClaim(scenario, kDeterministic)) ask(scenario.world, motions.again);
  std::vector<Trajectory> given = oracle.SimulateEach(worlds);
  for (std::size_t i = 0; i < given.size(); ++i) *places[i] = std::move(given[i]);
  return motions;
}

}  // namespace touchstone
