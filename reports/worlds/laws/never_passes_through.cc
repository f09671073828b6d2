#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/law_support/reach.h"
#include "reports/worlds/law_support/reported_impulses.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/swept.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** A body that has moved by less than this share of its bounding radius is where it was:
 resting bodies are not looked at again. [-] */
constexpr double kUnmoved = 1e-3;

/** The largest turn between two samples that is followed: rods, springs and gyroscopic
 terms may bend a longer one unseen. [rad] */
constexpr double kMostTurn = 1;

/** The same within a step, in which an engine has one spin: the shorter way round is then
 the one that the body took. [rad] */
constexpr double kMostTurnOfAStep = 3;

/** The largest difference of the turn that a step made from that by its spin, for a turn
 that is followed so far. [rad] */
constexpr double kUneven = 0.1;

/** Returns the pairs that the claim is about: half-spaces have no other side. */
std::vector<std::pair<int, int>> PairsOf(const World& world, const Claim& claim) {
  const auto is_bounded = [&](int body) {
    return !std::holds_alternative<HalfSpace>(
        world.bodies[static_cast<std::size_t>(body)].placed.shape);
  };
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [A, B] : CollidingPairs(world, claim))
    if (is_bounded(A) && is_bounded(B)) pairs.emplace_back(A, B);
  return pairs;
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (faults.empty() && PairsOf(world, claim).empty()) {
    faults.push_back({"about", "collides with nothing that it could pass through",
                      "two bodies that collide and are no half-spaces"});
  }
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

/** Causes that may have bent the path of a body, of the interval before each sample. */
struct Bends {
  bool is_held = false;          ///< Whether a rod or a spring holds the body.
  std::vector<double> velocity;  ///< The change beyond the loads. [m/s]
  std::vector<double> length;    ///< The length of the path, at most. [m]
  std::vector<double> spin;      ///< The change of the spin. [rad/s]
  std::vector<double> turn;      ///< The turn, at most. [rad]
};

/** Returns the sum over the intervals from one sample to another. Running totals would
 lose it beside a huge number of an earlier interval. */
double SumBetween(const std::vector<double>& values, std::size_t from, std::size_t to) {
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                         values.begin() + static_cast<std::ptrdiff_t>(to) + 1, 0.0);
}

/** Returns the causes of each body. */
std::vector<Bends> BendsOf(const Motion& motion, const AllowedMotion& slowed) {
  const std::size_t count = motion.world.bodies.size();
  const std::size_t samples = motion.trajectory.samples.size();
  const std::vector<double> none(samples, 0);
  std::vector<Bends> bends(
      count, {.velocity = none, .length = none, .spin = none, .turn = none});
  for (std::size_t i = 0; i < count; ++i)
    bends[i].is_held = IsHeld(motion.world, AnchorKind::kBody, static_cast<int>(i));
  for (std::size_t s = 1; s < samples; ++s) {
    const ReportedImpulses all = ReportedBefore(motion, s);
    for (std::size_t i = 0; i < count; ++i) {
      const RigidBody& it = motion.world.bodies[i];
      if (it.mass == 0) continue;
      const int body = static_cast<int>(i);
      const double time = slowed.times()[s] - slowed.times()[s - 1];
      const BodyState& was = slowed.At(s - 1).bodies[i];
      const BodyState& is = slowed.At(s).bodies[i];
      const Eigen::Vector3d& before = was.v_WB;
      const Eigen::Vector3d& after = is.v_WB;
      const Eigen::Vector3d by_loads = ImpulseOfLoads(motion, body, s) / it.mass;
      const double inertia = InertiaOf(it).minCoeff();
      double reported = 0;
      double reported_spin = 0;
      for (const ContactImpulse* contact : all.on_body[i]) {
        const double impulse = ImpulseOn(*contact, body).norm();
        reported += impulse / it.mass;
        reported_spin += impulse * (contact->p_WC - is.p_WB).norm() / inertia;
      }
      for (const Push* push :
           PushesBetween(motion.world, body, slowed.times()[s - 1], slowed.times()[s])) {
        reported += push->J_W.norm() / it.mass;
        reported_spin += push->J_W.norm() * push->p_BoP.norm() / inertia;
      }
      const double change = std::max((after - before - by_loads).norm(), reported);
      double way = (before.norm() + after.norm() + by_loads.norm()) * time;
      double turn = std::max(was.q_WB.normalized().angularDistance(is.q_WB.normalized()),
                             std::max(was.w_WB.norm(), is.w_WB.norm()) * time);
      Bends& of_body = bends[i];
      if (of_body.is_held && motion.world.sample_every > 1) {
        // A rod or a spring may have moved it and brought it to rest again between two
        // samples, with all the energy that there is. Within a step an engine has no
        // other velocities.
        const double energy = slowed.KineticEnergyBetween(s);
        way = std::max(way, std::sqrt(2 * energy / it.mass) * time);
        turn = std::max(turn, std::sqrt(2 * energy / inertia) * time);
      }
      of_body.velocity[s] = change;
      of_body.length[s] = way;
      of_body.spin[s] = std::max((is.w_WB - was.w_WB).norm(), reported_spin);
      of_body.turn[s] = turn;
    }
  }
  return bends;
}

/** Follows one pair along the motion. */
class Passage {
 public:
  Passage(const Motion& motion, const std::vector<Bends>& bends, int A, int B)
      : motion_(motion),
        A_(A),
        B_(B),
        bends_A_(bends[static_cast<std::size_t>(A)]),
        bends_B_(bends[static_cast<std::size_t>(B)]) {}

  void Judge(Worst& worst) {
    for (std::size_t s = 0; s < motion_.trajectory.samples.size(); ++s) {
      if (seen_ && IsWhereItWas(s)) {
        unmoved_ = s;
        continue;
      }
      // A body that has hardly moved may yet have entered another that it hardly missed.
      if (seen_apart_ && unmoved_ > *seen_ && IsApart(unmoved_)) apart_ = unmoved_;
      seen_ = s;
      if (!apart_) {
        seen_apart_ = IsApart(s);
      } else {
        const std::vector<SweptOverlap> overlaps = Sweep(*apart_, s);
        seen_apart_ = overlaps.empty() || IsApart(s);
        if (seen_apart_) {
          for (const SweptOverlap& overlap : overlaps) Take(overlap, *apart_, s, worst);
        }
      }
      if (seen_apart_) apart_ = s;
    }
  }

 private:
  const WorldState& At(std::size_t s) const { return motion_.trajectory.samples[s]; }

  const BodyState& Body(std::size_t s, int body) const {
    return At(s).bodies[static_cast<std::size_t>(body)];
  }

  const RigidBody& Asked(int body) const {
    return motion_.world.bodies[static_cast<std::size_t>(body)];
  }

  bool IsApart(std::size_t s) const {
    return OverlapOf(motion_.world, At(s), A_, B_).depth == 0;
  }

  bool IsWhereItWas(std::size_t s) const {
    for (const int body : {A_, B_}) {
      const BodyState& was = Body(*seen_, body);
      const BodyState& is = Body(s, body);
      const double radius = BoundingRadius(Asked(body).placed.shape);
      // Written so that a NaN has moved.
      if (!((is.p_WB - was.p_WB).norm() +
                radius * is.q_WB.normalized().angularDistance(was.q_WB.normalized()) <=
            kUnmoved * radius))
        return false;
    }
    return true;
  }

  /** Returns the overlaps on the way; nothing if the bodies are certainly apart on it. */
  std::vector<SweptOverlap> Sweep(std::size_t from, std::size_t to) const {
    const Eigen::Vector3d p_BA = Body(from, A_).p_WB - Body(from, B_).p_WB;
    const Eigen::Vector3d way = Body(to, A_).p_WB - Body(to, B_).p_WB - p_BA;
    const double share =
        way.isZero(0) ? 0 : std::clamp(-p_BA.dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double radii =
        BoundingRadius(Asked(A_).placed.shape) + BoundingRadius(Asked(B_).placed.shape);
    if ((p_BA + share * way).norm() > radii) return {};
    const auto turn = [&](const Bends& bends) {
      return SumBetween(bends.turn, from, to);
    };
    return SweptOverlapsOf(motion_.world, At(from), At(to), A_, B_,
                           {turn(bends_A_), turn(bends_B_), Followed(from, to)});
  }

  /** Returns up to which turn a body turns evenly, see Turns::followed. */
  double Followed(std::size_t from, std::size_t to) const {
    if (to - from > 1 || motion_.world.sample_every > 1) return kMostTurn;
    const auto is_even = [&](int body, const Bends& bends) {
      const BodyState& was = Body(from, body);
      const BodyState& is = Body(to, body);
      const Eigen::AngleAxisd turn(is.q_WB.normalized() *
                                   was.q_WB.normalized().conjugate());
      const Eigen::Vector3d made_W = turn.angle() * turn.axis();
      const double dt = motion_.world.dt;
      return !bends.is_held && std::min((made_W - dt * was.w_WB).norm(),
                                        (made_W - dt * is.w_WB).norm()) <= kUneven;
    };
    return is_even(A_, bends_A_) && is_even(B_, bends_B_) ? kMostTurnOfAStep : kMostTurn;
  }

  void Take(const SweptOverlap& overlap, std::size_t from, std::size_t to, Worst& worst) {
    const World& world = motion_.world;
    const double time = motion_.trajectory.times[to] - motion_.trajectory.times[from];
    Eigen::Vector3d loads_W = Eigen::Vector3d::Zero();
    if (Asked(A_).mass > 0) loads_W += AccelerationOf(world, Asked(A_));
    if (Asked(B_).mass > 0) loads_W -= AccelerationOf(world, Asked(B_));
    const auto between = [&](const std::vector<double>& values) {
      return SumBetween(values, from, to);
    };
    const double change = between(bends_A_.velocity) + between(bends_B_.velocity);
    const double length = between(bends_A_.length) + between(bends_B_.length);
    // A turn whose rate changes leaves the even turn as a path leaves its chord.
    // Between two samples it is at most half the path off; over more of them the path may
    // be left at once.
    const double most = to - from > 1 ? 1 : 0.5;
    const auto turned_aside = [&](const Bends& bends) {
      const double most_turned = most * between(bends.turn);
      return bends.is_held ? most_turned
                           : std::min(between(bends.spin) * time / 4, most_turned);
    };
    // The velocities at the samples do not tell what a rod or a spring did between.
    const bool is_held = bends_A_.is_held || bends_B_.is_held;
    const double longest = most * length;
    const double aside =
        is_held ? longest
                : std::min(change * time / 4 + loads_W.norm() * time * time / 8, longest);
    const double bend = aside + overlap.lever_A * turned_aside(bends_A_) +
                        overlap.lever_B * turned_aside(bends_B_) + overlap.bend;
    const double reach = Body(to, A_).p_WB.norm() + Body(to, B_).p_WB.norm() +
                         Body(from, A_).p_WB.norm() + Body(from, B_).p_WB.norm();
    const double rounding = RoundingOf(motion_.oracle, StepsBefore(motion_, to)) * reach;
    worst.Take(overlap.depth, kSafety * bend + rounding, [&] {
      return Citing(
          "{} has {} clear of {} at {:.6g} s and at {:.6g} s, and the straight way "
          "between leads through it: a way around would have to lie {:.6g} m aside, {}",
          motion_.oracle.name, CitedName{Asked(A_).name}, CitedName{Asked(B_).name},
          motion_.trajectory.times[from], CitedTime{motion_.trajectory.times[to]},
          overlap.depth,
          bend > 0 ? fmt::format("and the motion can have left the straight one by at "
                                 "most {:.6g} m",
                                 bend)
                   : std::string("and nothing has turned the motion aside"));
    });
  }

  const Motion& motion_;
  int A_;
  int B_;
  const Bends& bends_A_;
  const Bends& bends_B_;
  std::optional<std::size_t> seen_;   ///< The last sample that was looked at.
  bool seen_apart_ = false;           ///< Whether they were apart there.
  std::size_t unmoved_ = 0;           ///< The last sample that was not looked at, if any.
  std::optional<std::size_t> apart_;  ///< The last sample at which they were apart.
};

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const AllowedMotion slowed(motion);
  Worst worst(
      MeasureKind::kPassage,
      "1.5 × (¼ Δv Δt + ⅛ a Δt²) that the way may leave its chord, at most half "
      "its length at speeds that the truth allows, which is granted at once to a body on "
      "a rod or a spring; ¼ R Δω Δt, R/128 and R θ²/8 for rotation, of which a ball "
      "inside "
      "the body has none; and 64 roundings per step");
  // Bodies that never come near each other pass nothing.
  worst.Take(0, 0, [] { return CitingProof(); });
  const std::vector<Bends> bends = BendsOf(motion, slowed);
  const Reach reach(motion);
  for (const auto& [A, B] : PairsOf(world, claim))
    if (reach.MayEverTouch(A, B)) Passage(motion, bends, A, B).Judge(worst);
  return FindingsOf({worst});
}

}  // namespace

/** Bodies that collide never pass through each other. [m]

 Two bodies that are apart at two samples have moved around each other. The volume
 that A sweeps along the chord of its path relative to B may overlap with B only as deep
 as the path may have left the chord. Samples between the two at
 which they overlap are left out: a body that is pushed out on the far side has passed
 through.

 A path on which the velocity changes by Δv in the time Δt leaves its chord by at most
 ¼ Δv Δt, and a constant acceleration a adds ⅛ a Δt². Δv is the change beyond the loads,
 or the sum of the reported impulses over the mass if that is more. No path leaves its
 chord by more than half its length, at speeds that the truth allows
 (law_support/allowed_motion.h). The tolerance is 1.5 times that, with the deviation by
 rotation (law_support/swept.h), and 64 roundings per step. A body without impulses,
 loads and rotation has only the roundings, whatever its step.

 The depth is the referee's, certified: the least distance by which the sweeping body
 would have had to leave its path. Half-spaces are left out, since nothing is on their
 other side: never_penetrates sees a body inside.

 About: bodies; pairs of which at least one is named. Numbers: none. */
constinit const Law kNeverPassesThrough = {
    .name = "never_passes_through",
    .documentation = "Bodies that collide never pass through each other.",
    .faults = Faults,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutEach(kNeverPassesThrough, world); },
};

}  // namespace touchstone
