#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/slop.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

bool IsGround(const RigidBody& body) {
  return body.mass == 0 && body.collides &&
         (std::holds_alternative<HalfSpace>(body.placed.shape) ||
          std::holds_alternative<Box>(body.placed.shape));
}

/** Returns the distance of a sphere's centre from a static body, < 0 inside. [m] */
double DistanceTo(const Body& ground, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d p_B = ground.X_WB.R_WB.transpose() * (p_W - ground.X_WB.p_WB);
  if (std::holds_alternative<HalfSpace>(ground.shape)) return p_B.z();
  const Eigen::Vector3d beyond =
      p_B.cwiseAbs() - std::get<Box>(ground.shape).half_extents;
  return beyond.cwiseMax(0).norm() + std::min(0.0, beyond.maxCoeff());
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  for (const int i : SubjectsOf(world, claim).bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    if (std::holds_alternative<Sphere>(body.placed.shape) && body.collides) continue;
    faults.push_back(
        FaultAbout(claim, body.name, "is no sphere that collides", "spheres"));
  }
  if (NumberOr(claim, "slope", 1) <= 0)
    faults.push_back({"numbers.slope", "is not positive", "a score over h²"});
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

/** Two bodies that may penetrate each other. */
struct Pair {
  std::size_t A;
  std::size_t B;
  double V = 0;  ///< The largest speed of approach so far. [m/s]
};

/** The distance and speed of a pair at one sample. */
struct Nearness {
  double gap;  ///< [m]
  /** Relative speed, plus what gravity may add by the next sample. [m/s] */
  double approach;
};

Nearness NearnessOf(const World& world, const WorldState& state, const Pair& pair) {
  const BodyState& a = state.bodies[pair.A];
  const BodyState& b = state.bodies[pair.B];
  const RigidBody& A = world.bodies[pair.A];
  const double r = RadiusOf(world.bodies[pair.B]);
  const double gap = A.mass > 0 ? (b.p_WB - a.p_WB).norm() - RadiusOf(A) - r
                                : DistanceTo(A.placed, b.p_WB) - r;
  return {gap, (b.v_WB - a.v_WB).norm() + world.gravity_W.norm() * SampleSpacing(world)};
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  const std::vector<int> spheres = SubjectsOf(world, claim).bodies;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto B = static_cast<std::size_t>(spheres[i]);
    for (std::size_t j = 0; j < i; ++j)
      pairs.push_back({static_cast<std::size_t>(spheres[j]), B});
    for (std::size_t A = 0; A < world.bodies.size(); ++A) {
      if (IsGround(world.bodies[A])) pairs.push_back({A, B});
    }
  }
  const double h = world.dt;
  const double g = world.gravity_W.norm();
  double score = 0;
  const double slop = motion.oracle.slop;
  double allowed = 0;
  double left = 0;  // The score of pairs that are as deep as the slop. [m²]
  double deepest = 0;
  const Pair* deepest_pair = nullptr;
  double deepest_at = 0;  // [s]
  double reach = 0;
  const AllowedMotion slowed(motion);
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
    const WorldState& state = slowed.At(s);
    for (Pair& pair : pairs) {
      const Nearness near = NearnessOf(world, state, pair);
      // The pair may touch before the next sample, or has touched since the last.
      if (near.gap <= near.approach * SampleSpacing(world))
        pair.V = std::max(pair.V, near.approach);
      if (near.gap >= 0) continue;
      const double depth = -near.gap;
      score += depth * depth;
      const double grants = pair.V * h + g * h * h + slop;
      allowed += grants * grants;
      left += slop * slop;
      if (depth <= deepest) continue;
      deepest = depth;
      deepest_pair = &pair;
      deepest_at = trajectory.times[s];
    }
    for (const int i : spheres)
      reach = std::max(reach, state.bodies[static_cast<std::size_t>(i)].p_WB.norm());
  }
  const auto samples = static_cast<double>(trajectory.samples.size());
  const double slope = NumberOr(claim, "slope", 0);
  Worst worst(
      MeasureKind::kPenetration,
      WithSlop(slope > 0 ? "1.5 √s h, the score s h² of hard solvers that the claim cites"
                         : "1.5 √ of the mean Σ (V h + g h²)² over the pairs that "
                           "overlap, V at most what the truth allows",
               motion.oracle));
  worst.Take(
      std::sqrt(score / samples),
      kSafety * (slope > 0 ? std::sqrt(slope) * h + std::sqrt(left / samples)
                           : std::sqrt(allowed / samples)) +
          RoundingOf(motion.oracle, 0) * reach,
      [&] {
        if (deepest_pair == nullptr) return CitingProof();
        const auto name = [&](std::size_t body) {
          return CitedName{world.bodies[body].name};
        };
        return Citing(
            "{} has √mean Σ depth² = {:.6g} m, a score of {:.6g} m²; {} and {} are "
            "deepest, by {:.6g} m after {:.6g} s",
            motion.oracle.name, std::sqrt(score / samples), score / samples,
            name(deepest_pair->A), name(deepest_pair->B), deepest, CitedTime{deepest_at});
      });
  return FindingsOf({worst});
}

constexpr std::array<std::string_view, 1> kNumbers = {"slope"};

}  // namespace

/** The mean penetration of many spheres in each other and in static bodies: √ of the mean
 over the samples of Σ depth² over all pairs (the "666" scenes of SimBenchmark, whose
 score is the square of it). [m]

 An engine that detects contacts once per step lets a pair penetrate by V h + g h². V is
 the speed of approach at samples after which the pair could touch before the next, at
 most what the truth allows. The tolerance is 1.5 times the same mean of those depths. If
 a `slope` s is given, the published score s h² of a hard solver, the tolerance is 1.5 √s
 h instead.

 About: spheres. Numbers: slope [m²/s²]. */
constinit const Law kPenetrationScore = {
    .name = "penetration_score",
    .documentation =
        "Spheres penetrate on average no deeper than a step at their speed allows.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
