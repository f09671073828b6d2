#include "reports/worlds/law_support/parting_work.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/clusters.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/law_support/reach.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** A normal is level if its share along the load is at most this, for the rounding of a
 pose and of its normal. [-] */
constexpr double kLevel = 1e-9;

/** Returns whether a push along `n_AB_W` lifts B, or its reaction lifts A. */
bool Lifts(const World& world, const Eigen::Vector3d& n_AB_W, int A, int B) {
  const Eigen::Vector3d a_A =
      AccelerationOf(world, world.bodies[static_cast<std::size_t>(A)]);
  const Eigen::Vector3d a_B =
      AccelerationOf(world, world.bodies[static_cast<std::size_t>(B)]);
  return n_AB_W.dot(a_A) > kLevel * a_A.norm() || -n_AB_W.dot(a_B) > kLevel * a_B.norm();
}

bool BothMove(const World& world, int A, int B) {
  return world.bodies[static_cast<std::size_t>(A)].mass > 0 &&
         world.bodies[static_cast<std::size_t>(B)].mass > 0;
}

}  // namespace

double WorkOfParting(const Motion& motion, const Subjects& subjects) {
  const World& world = motion.world;
  const WorldState start = StateAtStart(world);
  const Reach reach(motion);
  const std::vector<std::pair<int, int>> pairs = CollidingPairs(world, subjects);
  Clusters clusters(world.bodies.size());  // With the sum of the depths. [m]
  double deepest = 0;
  for (const auto& [A, B] : pairs) {
    if (!reach.MayTouch(0, A, B)) continue;
    const double depth = OverlapOf(world, start, A, B).depth;
    if (depth == 0) continue;
    // The first of a pair moves.
    clusters.Add(A, depth);
    if (BothMove(world, A, B)) clusters.Join(A, B);
    deepest = std::max(deepest, depth);
  }
  if (deepest == 0) return 0;
  for (const DistanceJoint& joint : world.joints) {
    if (joint.A.on == AnchorKind::kBody && joint.B.on == AnchorKind::kBody &&
        BothMove(world, joint.A.index, joint.B.index))
      clusters.Join(joint.A.index, joint.B.index);
  }
  std::vector<Body> placed;
  for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
    placed.push_back(PlacedAt(world, start, i));
  const auto rests = [&](int A, int B) {
    const double lift = clusters.SumAt(A) + clusters.SumAt(B);
    if (lift == 0 || clusters.Of(A) == clusters.Of(B) || !BothMove(world, A, B) ||
        AreFarApart(placed[static_cast<std::size_t>(A)],
                    placed[static_cast<std::size_t>(B)], lift))
      return false;
    const Gap gap = GapBetween(world, start, A, B);
    return gap.length <= lift && Lifts(world, gap.n_W, A, B);
  };
  // A cluster that has grown reaches farther.
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [A, B] : pairs) {
      if (!rests(A, B)) continue;
      clusters.Join(A, B);
      grew = true;
    }
  }
  double work = 0;
  for (const int i : subjects.bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    work += clusters.SumAt(i) * body.mass * AccelerationOf(world, body).norm();
  }
  return work;
}

}  // namespace touchstone
