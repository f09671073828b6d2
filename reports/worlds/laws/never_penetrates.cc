#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/allowed_depth.h"
#include "reports/worlds/law_support/approach_of_pair.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/clusters.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/law_support/reach.h"
#include "reports/worlds/law_support/slop.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
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

/** Returns the larger acceleration of two bodies by loads. [m/s²] */
double LargerAcceleration(const World& world, int A, int B) {
  double acceleration = 0;
  for (const int body : {A, B}) {
    const RigidBody& is = world.bodies[static_cast<std::size_t>(body)];
    if (is.mass > 0)
      acceleration = std::max(acceleration, AccelerationOf(world, is).norm());
  }
  return acceleration;
}

/** A pair of bodies that may touch at some sample. */
struct TouchingPair {
  int A;
  int B;
  bool is_judged;       ///< Whether the claim is about it.
  double at_start;      ///< Its depth at the start. [m]
  double acceleration;  ///< The larger one by loads. [m/s²]
  AllowedDepth allowed;
  double fastest = 0;        ///< The speed of approach since it was apart. [m/s]
  DeepestOverlap overlap{};  ///< At this sample.
  bool was_apart = true;     ///< At the sample before.
};

/** Judges the depths of all pairs from sample to sample. */
class Depths {
 public:
  Depths(const Motion& motion, const Claim& claim)
      : motion_(motion),
        world_(motion.world),
        approach_(motion),
        reach_(motion),
        slack_(NumberOr(claim, "slack", 0) + motion.oracle.slop),
        parted_by_(NumberOr(claim, "parted_by", std::numeric_limits<double>::infinity())),
        worst_(
            MeasureKind::kPenetration,
            fmt::format("1.5 × (V h + 2 a h²), V the speed of approach along the normal "
                        "at the deepest points since the pair was apart, at most what "
                        "the truth allows; later than two steps after an arrival, the "
                        "least depth since, 1.5 × 2 a h² and 1e-5 V t{}",
                        WithSlop(NumberOr(claim, "slack", 0) > 0
                                     ? ", and the slack that the claim grants"
                                     : "",
                                 motion.oracle))) {
    const WorldState start = StateAtStart(world_);
    std::vector<std::pair<int, int>> judged = CollidingPairs(world_, claim);
    if (!judged.empty()) worst_.Take(0, 0, [] { return CitingProof{}; });
    for (auto& [A, B] : judged)
      if (A > B) std::swap(A, B);
    std::sort(judged.begin(), judged.end());
    const auto add = [&](int A, int B) {
      const double acceleration = LargerAcceleration(world_, A, B);
      const bool is_judged = std::binary_search(
          judged.begin(), judged.end(), std::pair(std::min(A, B), std::max(A, B)));
      pairs_.push_back({A, B, is_judged, OverlapOf(world_, start, A, B).depth,
                        acceleration,
                        AllowedDepth(world_.dt, ByApproach(0, acceleration),
                                     kSolverResidual * acceleration * world_.dt)});
    };
    // Bodies that the claim leaves out arrive at those that it is about. The first of a
    // pair moves.
    const int count = static_cast<int>(world_.bodies.size());
    const auto moves = [&](int body) {
      return world_.bodies[static_cast<std::size_t>(body)].mass > 0;
    };
    for (int A = 0; A < count; ++A) {
      if (!moves(A)) continue;
      for (int B = 0; B < count; ++B) {
        if (Collide(world_, A, B) && (B > A || !moves(B)) && reach_.MayEverTouch(A, B))
          add(A, B);
      }
    }
  }

  std::vector<LawFinding> Judge() {
    for (std::size_t s = 0; s < motion_.trajectory.samples.size(); ++s) {
      for (TouchingPair& pair : pairs_) Place(s, pair);
      if (s > 0) TakeArrivals(s);
      for (TouchingPair& pair : pairs_) Hold(s, pair);
    }
    return FindingsOf({worst_});
  }

 private:
  /** Returns the depth that an approach at the speed `V` explains. [m] */
  double ByApproach(double V, double acceleration) const {
    return kSafety * world_.dt * (V + acceleration * (SampleSpacing(world_) + world_.dt));
  }

  double ByLoad(const TouchingPair& pair) const {
    return ByApproach(0, pair.acceleration);
  }

  /** Finds the overlap of a pair at sample `s`. */
  void Place(std::size_t s, TouchingPair& pair) const {
    pair.was_apart = pair.overlap.depth == 0;
    pair.overlap = reach_.MayTouch(s, pair.A, pair.B)
                       ? OverlapOf(world_, motion_.trajectory.samples[s], pair.A, pair.B)
                       : DeepestOverlap{};
    if (pair.overlap.depth > 0) return;
    pair.fastest = 0;
    pair.allowed.Part();
  }

  /** Finds the pairs that have arrived at sample `s`. They press on all pairs of their
   pile, through the bodies between them. */
  void TakeArrivals(std::size_t s) {
    Clusters piles(world_.bodies.size());
    for (const TouchingPair& pair : pairs_) {
      // A static body does not connect those that touch it.
      if (world_.bodies[static_cast<std::size_t>(pair.B)].mass > 0 &&
          reach_.MayTouch(s, pair.A, pair.B))
        piles.Join(pair.A, pair.B);
    }
    constexpr double kNone = -1;
    std::vector<double> fastest(world_.bodies.size(), kNone);  // Of each pile. [m/s]
    for (TouchingPair& pair : pairs_) {
      if (pair.overlap.depth == 0) continue;
      const double V = approach_.SpeedOf(s, pair.A, pair.B, pair.overlap);
      pair.fastest = std::max(pair.fastest, V);
      if (!HasArrived(s, pair)) continue;
      double& of_pile = fastest[piles.Of(pair.A)];
      of_pile = std::max(of_pile, V);
    }
    for (TouchingPair& pair : pairs_) {
      const double V = fastest[piles.Of(pair.A)];
      if (pair.overlap.depth == 0 || V == kNone) continue;
      pair.allowed.Arrive(motion_.trajectory.times[s], ByApproach(V, pair.acceleration),
                          kSolverResidual * V);
    }
  }

  /** Returns whether the pair has arrived at sample `s`: it was apart at the sample
   before, or its deepest point was no deeper then than a load and a rounding explain. The
   first step counts as well: it may begin at any speed. */
  bool HasArrived(std::size_t s, const TouchingPair& pair) const {
    if (s == 1 || pair.was_apart || approach_.MayHaveTouchedThird(s, pair.A, pair.B))
      return true;
    return pair.overlap.depth - approach_.DeepenedBy(s, pair.A, pair.B, pair.overlap) <=
           ByLoad(pair) + slack_ + RoundingAt(s, pair);
  }

  /** Returns the rounding of the depth of a pair at sample `s`. [m] */
  double RoundingAt(std::size_t s, const TouchingPair& pair) const {
    const WorldState& state = motion_.trajectory.samples[s];
    return RoundingOf(motion_.oracle, StepsBefore(motion_, s)) *
           (state.bodies[static_cast<std::size_t>(pair.A)].p_WB.norm() +
            state.bodies[static_cast<std::size_t>(pair.B)].p_WB.norm());
  }

  /** Judges the depth of a pair at sample `s`. */
  void Hold(std::size_t s, TouchingPair& pair) {
    const double time = motion_.trajectory.times[s];
    const double depth = pair.overlap.depth;
    // It is unknown how soon, if ever, an engine separates what overlaps at the start.
    const double granted = time < parted_by_ - world_.dt / 2 ? pair.at_start : 0;
    const double most = ByApproach(pair.fastest, pair.acceleration) + granted;
    if (depth > 0 && s == 0) pair.allowed.Begin(pair.at_start);
    const double allowed = depth > 0 ? pair.allowed.Next(time, depth) : most;
    if (!pair.is_judged) return;
    const auto a = static_cast<std::size_t>(pair.A);
    const auto b = static_cast<std::size_t>(pair.B);
    worst_.Take(depth, std::min(most, allowed) + slack_ + RoundingAt(s, pair), [&] {
      return Citing(
          "{} has {} {:.6g} m deep in {} after {:.6g} s; they approached at "
          "{:.6g} m/s at most{}",
          motion_.oracle.name, CitedName{world_.bodies[a].name}, depth,
          CitedName{world_.bodies[b].name}, CitedTime{time}, pair.fastest,
          allowed < most && pair.allowed.IsSettled()
              ? fmt::format(", and had been only {:.6g} m deep", pair.allowed.kept())
              : "");
    });
  }

  const Motion& motion_;
  const World& world_;
  ApproachOfPair approach_;
  Reach reach_;
  double slack_;
  double parted_by_;
  Worst worst_;
  std::vector<TouchingPair> pairs_;
};

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return Depths(motion, claim).Judge();
}

constexpr std::array<std::string_view, 2> kNumbers = {"parted_by", "slack"};

}  // namespace

/** Bodies that collide never penetrate deeper than they can move in one step. [m]

 A contact that is first detected at the end of a step is at most V h deep, where V is the
 speed at which the surfaces approach there. A load adds up to 2 a h² before the contact
 resists, with a = |g + F/m|; an engine need not undo that. The tolerance is 1.5 times
 that depth, and 64 roundings per step. A penetration at the start is granted. The depth
 is the referee's, certified. V h is granted for two steps after an arrival. Later
 the least depth since then takes its place (law_support/allowed_depth.h).

 V is taken at the deepest point and along the direction of the depth: |n·u_A| + |n·u_B|
 with u = v + ω × r, at the sample and at the one before, and the largest since the pair
 was apart. So sliding and spin about the normal do not enlarge the tolerance. The two
 speeds are added, not subtracted, since an impact may stop one of two bodies that move
 together. No speed is larger than the truth allows (law_support/allowed_motion.h).

 Between samples that are further apart than a step, a body may turn: its |n × ω| |r|
 counts in full, and gravity over that time. If it may also touch a third body meanwhile,
 that may transfer its own speed, so the |v| + |ω| |r| of the fastest body counts.

 About: bodies; pairs of which at least one is named. Numbers: slack [m], granted on top,
 with its reason in the claim's `because`; parted_by [s], the time from which a
 penetration at the start is no longer granted. */
constinit const Law kNeverPenetrates = {
    .name = "never_penetrates",
    .documentation =
        "Colliding bodies penetrate by at most V h + 2 a h²; slack [m] is granted on "
        "top, and until parted_by [s] also the overlap at the start.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutEach(kNeverPenetrates, world); },
};

}  // namespace touchstone
