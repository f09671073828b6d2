#include "reports/worlds/laws/never_passes_through.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reports/worlds/law_support/allowed_motion.h"
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
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** A body that has moved by less than this share of its bounding radius is where it was:
 resting bodies are not looked at again. [-] */
constexpr double kUnmoved = 1e-3;

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

/** Causes that may have bent the path of a body, summed from the start to each sample. */
struct Bends {
  std::vector<double> velocity;  ///< Σ of the changes beyond the loads. [m/s]
  std::vector<double> length;    ///< Σ of the paths, at most. [m]
};

/** Returns the causes of each body. */
std::vector<Bends> BendsOf(const Motion& motion, const AllowedMotion& slowed) {
  const std::size_t count = motion.world.bodies.size();
  const std::size_t samples = motion.trajectory.samples.size();
  std::vector<Bends> bends(
      count, {std::vector<double>(samples, 0), std::vector<double>(samples, 0)});
  for (std::size_t s = 1; s < samples; ++s) {
    const ReportedImpulses all = ReportedBefore(motion, s);
    for (std::size_t i = 0; i < count; ++i) {
      const RigidBody& it = motion.world.bodies[i];
      if (it.mass == 0) continue;
      const int body = static_cast<int>(i);
      const Eigen::Vector3d& before = slowed.At(s - 1).bodies[i].v_WB;
      const Eigen::Vector3d& after = slowed.At(s).bodies[i].v_WB;
      const Eigen::Vector3d by_loads = ImpulseOfLoads(motion, body, s) / it.mass;
      double reported = 0;
      for (const ContactImpulse* contact : all.on_body[i])
        reported += ImpulseOn(*contact, body).norm() / it.mass;
      const double change = std::max((after - before - by_loads).norm(), reported);
      const double way = (before.norm() + after.norm() + by_loads.norm()) *
                         (slowed.times()[s] - slowed.times()[s - 1]);
      bends[i].velocity[s] = bends[i].velocity[s - 1] + change;
      bends[i].length[s] = bends[i].length[s - 1] + way;
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
        if (seen_apart_) apart_ = s;
        continue;
      }
      seen_ = s;
      if (!apart_) {
        seen_apart_ = IsApart(s);
      } else {
        const SweptOverlap swept = Sweep(*apart_, s);
        // The swept volume contains the body at both ends.
        seen_apart_ = swept.depth == 0 || IsApart(s);
        if (seen_apart_) Take(swept, *apart_, s, worst);
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

  SweptOverlap Sweep(std::size_t from, std::size_t to) const {
    const Eigen::Vector3d p_BA = Body(from, A_).p_WB - Body(from, B_).p_WB;
    const Eigen::Vector3d way = Body(to, A_).p_WB - Body(to, B_).p_WB - p_BA;
    const double share =
        way.isZero(0) ? 0 : std::clamp(-p_BA.dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double radii =
        BoundingRadius(Asked(A_).placed.shape) + BoundingRadius(Asked(B_).placed.shape);
    if ((p_BA + share * way).norm() > radii) return {};
    return SweptOverlapOf(motion_.world, At(from), At(to), A_, B_);
  }

  void Take(const SweptOverlap& swept, std::size_t from, std::size_t to, Worst& worst) {
    const World& world = motion_.world;
    const double time = motion_.trajectory.times[to] - motion_.trajectory.times[from];
    Eigen::Vector3d loads_W = Eigen::Vector3d::Zero();
    if (Asked(A_).mass > 0) loads_W += AccelerationOf(world, Asked(A_));
    if (Asked(B_).mass > 0) loads_W -= AccelerationOf(world, Asked(B_));
    const auto between = [&](const std::vector<double>& sum) {
      return sum[to] - sum[from];
    };
    const double change = between(bends_A_.velocity) + between(bends_B_.velocity);
    const double length = between(bends_A_.length) + between(bends_B_.length);
    const double bend =
        std::min(change * time / 4 + loads_W.norm() * time * time / 8, length / 2) +
        swept.bend;
    const double reach = Body(to, A_).p_WB.norm() + Body(to, B_).p_WB.norm() +
                         Body(from, A_).p_WB.norm() + Body(from, B_).p_WB.norm();
    const double rounding = RoundingOf(motion_.oracle, StepsBefore(motion_, to)) * reach;
    worst.Take(swept.depth, kSafety * bend + rounding, [&] {
      return fmt::format(
          "{} has {} apart from {} at {:.6g} s and at {:.6g} s; on the straight way "
          "between the two they are {:.6g} m inside each other, and the motion bends it "
          "by at most {:.6g} m",
          motion_.oracle.name, Asked(A_).name, Asked(B_).name,
          motion_.trajectory.times[from], motion_.trajectory.times[to], swept.depth,
          bend);
    });
  }

  const Motion& motion_;
  int A_;
  int B_;
  const Bends& bends_A_;
  const Bends& bends_B_;
  std::optional<std::size_t> seen_;   ///< The last sample that was looked at.
  bool seen_apart_ = false;           ///< Whether they were apart there.
  std::optional<std::size_t> apart_;  ///< The last sample at which they were apart.
};

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const AllowedMotion slowed(motion);
  Worst worst(MeasureKind::kPassage,
              "1.5 × (¼ Δv Δt + ⅛ a Δt²) that the way may leave its chord, at most half "
              "its length at speeds that the truth allows, and R θ²/8 for rotation; and "
              "64 roundings per step");
  // Bodies that never come near each other pass nothing.
  worst.Take(0, 0, [] { return std::string(); });
  const std::vector<Bends> bends = BendsOf(motion, slowed);
  const Reach reach(motion);
  for (const auto& [A, B] : PairsOf(world, claim))
    if (reach.MayEverTouch(A, B)) Passage(motion, bends, A, B).Judge(worst);
  return FindingsOf({worst});
}

}  // namespace

constinit const Law kNeverPassesThrough = {
    .name = "never_passes_through",
    .documentation = "Bodies that collide never pass through each other.",
    .faults = Faults,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutEach(kNeverPassesThrough, world); },
};

}  // namespace touchstone
