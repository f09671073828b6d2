#include "reports/worlds/laws/never_penetrates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/law_support/reach.h"
#include "reports/worlds/law_support/slop.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (NumberOr(claim, "slack", 0) < 0)
    faults.push_back({"numbers.slack", "is negative", "a length >= 0"});
  const double parted_by = NumberOr(claim, "parted_by", 0);
  if (parted_by < 0 || parted_by >= world.steps * world.dt)
    faults.push_back({"numbers.parted_by", fmt::format("is {:.6g} s", parted_by),
                      "a time before the end"});
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

/** Returns, for each body, whether it may touch more than one other body between samples
 `s` − 1 and `s`. */
std::vector<bool> MayTouchSeveral(const World& world, const AllowedMotion& slowed,
                                  std::size_t s) {
  const std::size_t count = world.bodies.size();
  std::vector<Body> placed;
  std::vector<double> travelled;
  const double time = SampleSpacing(world);
  for (std::size_t i = 0; i < count; ++i) {
    placed.push_back(PlacedAt(world, slowed.At(s - 1), static_cast<int>(i)));
    const double speed =
        slowed.At(s - 1).bodies[i].v_WB.norm() + slowed.At(s).bodies[i].v_WB.norm();
    travelled.push_back(
        world.bodies[i].mass > 0
            ? time * (speed + AccelerationOf(world, world.bodies[i]).norm() * time)
            : 0);
  }
  std::vector<int> near(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!Collide(world, static_cast<int>(i), static_cast<int>(j)) ||
          AreFarApart(placed[i], placed[j], travelled[i] + travelled[j]))
        continue;
      ++near[i];
      ++near[j];
    }
  }
  std::vector<bool> several;
  for (const int n : near) several.push_back(n > 1);
  return several;
}

/** How one of two bodies that penetrate each other moves at the deepest point. */
class Approach {
 public:
  Approach(const World& world, int body, const BodyState& deep,
           const DeepestOverlap& overlap)
      : world_(world),
        body_(world.bodies[static_cast<std::size_t>(body)]),
        n_W_(overlap.n_W),
        r_B_(deep.q_WB.normalized().conjugate() * (overlap.p_W - deep.p_WB)) {}

  /** Returns how fast the point moves along the normal at a state of the body, and may
   come to move within a step as the body turns. [m/s] */
  double AlongNormal(const BodyState& at) const {
    const Eigen::Vector3d r_W = at.q_WB.normalized() * r_B_;
    const Eigen::Vector3d turning_W = at.w_WB.cross(r_W);
    return std::abs(n_W_.dot(at.v_WB + turning_W)) +
           world_.dt * std::abs(n_W_.dot(at.w_WB.cross(turning_W)));
  }

  /** Returns the same for a body that may have turned anywhere about the part of its spin
   along the normal. [m/s] */
  double Turned(const BodyState& at) const {
    return std::abs(n_W_.dot(at.v_WB)) + n_W_.cross(at.w_WB).norm() * Lever();
  }

 private:
  double Lever() const {
    return std::holds_alternative<Sphere>(body_.placed.shape) ? 0 : r_B_.norm();
  }

  const World& world_;
  const RigidBody& body_;
  Eigen::Vector3d n_W_;
  Eigen::Vector3d r_B_;
};

/** Returns the largest speed of any point of a body that moves and collides. [m/s] */
double FastestOf(const World& world, const WorldState& state) {
  double fastest = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& body = world.bodies[i];
    if (body.mass == 0 || !body.collides) continue;
    const double lever = std::holds_alternative<Sphere>(body.placed.shape)
                             ? 0
                             : BoundingRadius(body.placed.shape);
    fastest = std::max(fastest,
                       state.bodies[i].v_WB.norm() + state.bodies[i].w_WB.norm() * lever);
  }
  return fastest;
}

/** Returns how fast a body may have approached along the normal from sample `s` − 1 to
 sample `s`, at which it is as deep as `overlap` says. `several` says whether it may have
 touched a third body meanwhile. [m/s] */
double ApproachSpeed(const World& world, const AllowedMotion& slowed, std::size_t s,
                     int body, const DeepestOverlap& overlap, bool several) {
  const auto i = static_cast<std::size_t>(body);
  if (world.bodies[i].mass == 0) return 0;
  const Approach approach(world, body, slowed.At(s).bodies[i], overlap);
  double fastest = 0;
  for (const std::size_t k : {s - 1, s}) {
    const BodyState& at = slowed.At(k).bodies[i];
    fastest = std::max(fastest, world.sample_every == 1 ? approach.AlongNormal(at)
                                : several               ? FastestOf(world, slowed.At(k))
                                                        : approach.Turned(at));
  }
  return fastest;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  const double slack = NumberOr(claim, "slack", 0) + motion.oracle.slop;
  // It is unknown how soon, if ever, an engine separates what overlaps at the start.
  const double parted_by =
      NumberOr(claim, "parted_by", std::numeric_limits<double>::infinity());
  const AllowedMotion slowed(motion);
  std::vector<std::vector<bool>> several(1);
  for (std::size_t s = 1; s < trajectory.samples.size(); ++s) {
    several.push_back(world.sample_every > 1
                          ? MayTouchSeveral(world, slowed, s)
                          : std::vector<bool>(world.bodies.size(), false));
  }
  Worst worst(
      MeasureKind::kPenetration,
      fmt::format("1.5 × (V h + 2 a h²), V the speed of approach along the normal "
                  "at the deepest points since the pair was apart, at most what "
                  "the truth allows{}",
                  WithSlop(NumberOr(claim, "slack", 0) > 0
                               ? ", and the slack that the claim grants"
                               : "",
                           motion.oracle)));
  const WorldState start = StateAtStart(world);
  const Reach reach(motion);
  const auto hold = [&](int A, int B) {
    const auto a = static_cast<std::size_t>(A);
    const auto b = static_cast<std::size_t>(B);
    const double at_start = OverlapOf(world, start, A, B).depth;
    double acceleration = 0;
    for (const std::size_t i : {a, b}) {
      if (world.bodies[i].mass > 0)
        acceleration =
            std::max(acceleration, AccelerationOf(world, world.bodies[i]).norm());
    }
    double V = 0;
    const std::size_t end = reach.MayEverTouch(A, B) ? trajectory.samples.size() : 1;
    for (std::size_t s = 0; s < end; ++s) {
      if (s > 0 && !reach.MayTouch(s, A, B)) {
        V = 0;
        continue;
      }
      const WorldState& state = trajectory.samples[s];
      const DeepestOverlap overlap = OverlapOf(world, state, A, B);
      if (overlap.depth == 0) {
        V = 0;
      } else if (s > 0) {
        V = std::max(V, ApproachSpeed(world, slowed, s, A, overlap, several[s][a]) +
                            ApproachSpeed(world, slowed, s, B, overlap, several[s][b]));
      }
      const double granted =
          trajectory.times[s] < parted_by - world.dt / 2 ? at_start : 0;
      const double between = V + acceleration * SampleSpacing(world);
      const double size = state.bodies[a].p_WB.norm() + state.bodies[b].p_WB.norm();
      worst.Take(overlap.depth,
                 kSafety * world.dt * (between + acceleration * world.dt) + granted +
                     slack + RoundingOf(motion.oracle, StepsBefore(motion, s)) * size,
                 [&] {
                   return fmt::format(
                       "{} has {} {:.6g} m deep in {} after {:.6g} s; they approached at "
                       "{:.6g} m/s at most",
                       motion.oracle.name, world.bodies[a].name, overlap.depth,
                       world.bodies[b].name, trajectory.times[s], V);
                 });
    }
  };
  for (const auto& [A, B] : CollidingPairs(world, claim)) hold(A, B);
  return FindingsOf({worst});
}

constexpr std::array<std::string_view, 2> kNumbers = {"parted_by", "slack"};

}  // namespace

constinit const Law kNeverPenetrates = {
    .name = "never_penetrates",
    .documentation =
        "Colliding bodies penetrate by at most V h + 2 a h²; slack [m] is granted on "
        "top, "
        "and "
        "until parted_by [s] also the overlap at the start.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutEach(kNeverPenetrates, world); },
};

}  // namespace touchstone
