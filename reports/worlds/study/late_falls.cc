#include "reports/worlds/study/late_falls.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "reports/worlds/law_support/clusters.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Returns the size relative to which the place of a body's surface is rounded. [m] */
double ReachOf(const Body& body) {
  const double place = body.X_WB.p_WB.cwiseAbs().maxCoeff();
  return std::holds_alternative<HalfSpace>(body.shape)
             ? place
             : place + BoundingRadius(body.shape);
}

bool JustTouch(const World& world, const WorldState& start, int A, int B,
               double rounding) {
  if (AreFarApart(PlacedAt(world, start, A), PlacedAt(world, start, B), rounding))
    return false;
  return OverlapOf(world, start, A, B).depth <= rounding &&
         GapBetween(world, start, A, B).length <= rounding;
}

}  // namespace

std::vector<LateFall> LateFallsOf(const Study& study) {
  const World& world = study.scenario.world;
  const WorldState start = StateAtStart(world);
  Clusters clusters(world.bodies.size());  // With the number of contacts.
  for (const auto& [A, B] : CollidingPairs(world, SubjectsOf(world, {}))) {
    // That of a large floor decides, too.
    const double rounding =
        RoundingOf(study.oracle, 0) *
        (ReachOf(PlacedAt(world, start, A)) + ReachOf(PlacedAt(world, start, B)));
    if (!JustTouch(world, start, A, B, rounding)) continue;
    clusters.Add(A, 1);
    if (world.bodies[static_cast<std::size_t>(B)].mass > 0) clusters.Join(A, B);
  }
  std::vector<LateFall> falls(world.bodies.size());
  for (std::size_t i = 0; i < falls.size(); ++i) {
    const double contacts = clusters.SumAt(static_cast<int>(i));
    if (contacts == 0) continue;
    falls[i] = {world.dt * world.dt * AccelerationOf(world, world.bodies[i]), contacts};
  }
  return falls;
}

Trajectory WithoutLateFalls(Trajectory motion, const Trajectory& reference,
                            const std::vector<LateFall>& falls) {
  const std::size_t samples = std::min(motion.samples.size(), reference.samples.size());
  for (std::size_t s = 0; s < samples; ++s) {
    for (std::size_t i = 0; i < falls.size(); ++i) {
      const Eigen::Vector3d& fall_W = falls[i].each_W;
      if (fall_W.isZero(0)) continue;
      Eigen::Vector3d& p_W = motion.samples[s].bodies[i].p_WB;
      const Eigen::Vector3d off_W = p_W - reference.samples[s].bodies[i].p_WB;
      const double whole = std::round(2 * off_W.dot(fall_W) / fall_W.squaredNorm()) / 2;
      p_W -= std::clamp(whole, -falls[i].most, falls[i].most) * fall_W;
    }
  }
  return motion;
}

}  // namespace touchstone
