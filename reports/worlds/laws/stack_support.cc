#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Returns the levels from `level` upwards. */
Subjects From(const std::vector<int>& levels, std::size_t level) {
  return {{levels.begin() + static_cast<std::ptrdiff_t>(level), levels.end()}, {}, {}};
}

double WeightOf(const World& world, const std::vector<int>& levels, std::size_t from) {
  return MassOf(world, From(levels, from)) * world.gravity_W.norm();
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  if (world.gravity_W.isZero(0))
    return {{"about", "are in a world without gravity", "weight"}};
  const std::vector<int> levels = SubjectsOf(world, claim).bodies;
  const Eigen::Vector3d up_W = -world.gravity_W.normalized();
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(levels[k])];
    std::string why;
    if (!body.force_W.isZero(0) || IsPushed(world, levels[k]) ||
        IsHeld(world, AnchorKind::kBody, levels[k]))
      why = "has a force, or is pushed or held";
    else if (!body.v_WB.isZero(0) || !body.w_WB.isZero(0))
      why = "moves at the start";
    else if (k > 0 && up_W.dot(body.placed.X_WB.p_WB -
                               world.bodies[static_cast<std::size_t>(levels[k - 1])]
                                   .placed.X_WB.p_WB) <= 0)
      why = "is not above its predecessor";
    if (why.empty()) continue;
    faults.push_back(FaultAbout(claim, body.name, why,
                                "bodies at rest, from the lowest to the highest"));
  }
  return Joined(
      std::move(faults),
      FaultsOfNumbers(claim, {{"expected_weight", WeightOf(world, levels, 0)}}));
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  if (!trajectory.gives_impulses || trajectory.samples.size() < 3) return {};
  const std::vector<int> levels = SubjectsOf(world, claim).bodies;
  const auto is_level = [&](int index) {
    return std::find(levels.begin(), levels.end(), index) != levels.end();
  };
  const std::size_t first = trajectory.samples.size() / 2;
  const std::size_t last = trajectory.samples.size() - 1;
  const double T = trajectory.times[last] - trajectory.times[first];
  const Eigen::Vector3d up_W = -world.gravity_W.normalized();
  Worst worst(MeasureKind::kForceError,
              "1.5 × the momentum gained by the levels carried, at most that of 2 g h a "
              "level, over the time of the mean; and 64 roundings per step");
  for (std::size_t k = 0; k < levels.size(); ++k) {
    double impulse = 0;
    for (const ContactImpulse* contact : ImpulsesBetween(motion, first, last)) {
      const int other = contact->A == levels[k] ? contact->B : contact->A;
      const bool from_below = k == 0 ? !is_level(other) : other == levels[k - 1];
      if (from_below) impulse += up_W.dot(ImpulseOn(*contact, levels[k]));
    }
    const double weight = WeightOf(world, levels, k);
    const Subjects above = From(levels, k);
    const double gained = (MomentumOf(world, trajectory.samples[last], above) -
                           MomentumOf(world, trajectory.samples[first], above))
                              .norm();
    const double at_rest = 2 * 2 * static_cast<double>(levels.size()) * weight * world.dt;
    worst.Take(std::abs(impulse / T - weight),
               kSafety * std::min(gained, at_rest) / T +
                   RoundingOf(motion.oracle, StepsBefore(motion, last)) * weight,
               [&] {
                 return Citing(
                     "{} holds {} from below with {:.9g} N on average from {:.6g} to "
                     "{:.6g} s; it and the levels above weigh {:.9g} N",
                     motion.oracle.name,
                     CitedName{world.bodies[static_cast<std::size_t>(levels[k])].name},
                     impulse / T, trajectory.times[first],
                     CitedTime{trajectory.times[last]}, weight);
               });
  }
  return FindingsOf({worst});
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_weight"};

}  // namespace

/** In a stack at rest each level carries everything above it: the contacts between level
 k − 1 and level k exert Σ_{i >= k} m_i g against gravity. [N]

 The force is the mean over the second half of the motion, of duration T. Momentum
 balances whatever the solver does. So the mean is off by the momentum that the levels
 from k on gain in T, over T, × 1.5. At rest that is at most the contacts' 2 g h per level
 (laws/rests.cc), at both ends of T. 64 roundings per step are added.

 Judges only engines that report contact impulses. About: bodies from the lowest to the
 highest, each on its predecessor, the first on something static. Numbers: expected_weight
 of all [N]. */
constinit const Law kStackSupport = {
    .name = "stack_support",
    .documentation =
        "In a stack at rest each level carries everything "
        "above it; about names the levels from below.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
