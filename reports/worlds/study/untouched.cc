#include "reports/worlds/study/untouched.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/law_support/reach.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** The share of a motion within which it is the same. */
constexpr double kSame = 0.01;

Subjects SubjectNamed(const World& world, std::string_view name) {
  Claim claim;
  claim.about = {std::string(name)};
  return SubjectsOf(world, claim);
}

/** The roundings of a motion up to one sample. */
struct Roundings {
  double place;  ///< Of a place, as a share of its distance from the origin. [-]
  /** Of a velocity, as a share of the place: an engine that takes it from places knows it
   no better than these, over a step. [1/s] */
  double rate;
};

Roundings RoundingsAt(const Motion& motion, std::size_t s) {
  return {RoundingOf(motion.oracle, StepsBefore(motion, s)),
          RoundingOf(motion.oracle, 0) / motion.world.dt};
}

/** Returns whether `point` has fallen freely at sample `s`. */
bool HasFallen(const Motion& motion, const PointMass& point, std::size_t s) {
  const PointState is = point.In(motion.trajectory.samples[s]);
  const double t = motion.trajectory.times[s];
  const Eigen::Vector3d v_W = point.start.v_W + t * point.a_W;
  const Eigen::Vector3d p_W =
      point.start.p_W + t * point.start.v_W + t * t / 2 * point.a_W;
  const double a = point.a_W.norm();
  const double off = a * motion.world.dt + kSame * (point.start.v_W.norm() + a * t);
  const Roundings roundings = RoundingsAt(motion, s);
  return (is.v_W - v_W).norm() <= off + roundings.rate * p_W.norm() &&
         (is.p_W - p_W).norm() <= off * t + roundings.place * p_W.norm();
}

/** Returns whether body `i` keeps its spin or its angular momentum at sample `s`. */
bool TurnsFreely(const Motion& motion, const BodyState& start, std::size_t i,
                 std::size_t s) {
  const RigidBody& body = motion.world.bodies[i];
  const BodyState& is = motion.trajectory.samples[s].bodies[i];
  const double off = kSame * start.w_WB.norm() + RoundingsAt(motion, s).rate;
  if ((is.w_WB - start.w_WB).norm() <= off) return true;
  const Eigen::Vector3d L_W = InertiaInWorld(body, start.q_WB) * start.w_WB;
  const Eigen::Vector3d L_is_W = InertiaInWorld(body, is.q_WB) * is.w_WB;
  return (L_is_W - L_W).norm() <= kSame * L_W.norm();
}

/** Returns the number of samples up to `until` [s]. */
std::size_t SamplesUntil(const Motion& motion, double until) {
  const std::vector<double>& times = motion.trajectory.times;
  // Times are multiples of the step, to rounding.
  const double end = until + motion.world.dt / 2;
  return static_cast<std::size_t>(std::ranges::upper_bound(times, end) - times.begin());
}

/** Returns whether A and B may meet between sample `s` and the next. */
bool MayMeetAfter(const Motion& motion, std::size_t s, int A, int B) {
  const World& world = motion.world;
  const WorldState& state = motion.trajectory.samples[s];
  const double way = WayAfter(motion, s, A) + WayAfter(motion, s, B) + motion.oracle.slop;
  if (AreFarApart(PlacedAt(world, state, A), PlacedAt(world, state, B), way))
    return false;
  return GapBetween(world, state, A, B).length <= way;
}

}  // namespace

bool IsUntouched(const Motion& motion, std::string_view name, double until) {
  const WorldState start = StateAtStart(motion.world);
  const std::size_t count = SamplesUntil(motion, until);
  for (const PointMass& point :
       PointMassesOf(motion.world, SubjectNamed(motion.world, name))) {
    for (std::size_t s = 0; s < count; ++s) {
      if (!HasFallen(motion, point, s)) return false;
      if (point.on != AnchorKind::kBody) continue;
      const auto i = static_cast<std::size_t>(point.index);
      if (!TurnsFreely(motion, start.bodies[i], i, s)) return false;
    }
  }
  return true;
}

bool MayBeTouched(const Motion& motion, std::string_view name, double until) {
  const World& world = motion.world;
  const Subjects subjects = SubjectNamed(world, name);
  for (const PointMass& point : PointMassesOf(world, subjects)) {
    if (IsHeld(world, point.on, point.index) || point.damping > 0 ||
        !world.cloths.empty())
      return true;
    if (point.on == AnchorKind::kParticle)
      return std::ranges::any_of(world.bodies, &RigidBody::collides);
    if (IsPushed(world, point.index)) return true;
  }
  const std::size_t count = SamplesUntil(motion, until);
  for (const auto& [A, B] : CollidingPairs(world, subjects)) {
    for (std::size_t s = 0; s < count; ++s)
      if (MayMeetAfter(motion, s, A, B)) return true;
  }
  return false;
}

}  // namespace touchstone
