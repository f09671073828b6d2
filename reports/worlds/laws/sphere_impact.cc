#include "reports/worlds/laws/sphere_impact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/sphere_meeting.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** Overlap at the start that counts as rounding, over the sum of the radii. [-] */
constexpr double kApart = 1e-9;

SphereMeeting MeetingOf(const World& world, const std::vector<int>& bodies) {
  const RigidBody& A = world.bodies[static_cast<std::size_t>(bodies[0])];
  const RigidBody& B = world.bodies[static_cast<std::size_t>(bodies[1])];
  SphereMeeting meeting;
  meeting.A = SideOf(world, bodies[0]);
  meeting.B = SideOf(world, bodies[1]);
  meeting.restitution = std::min(A.restitution, B.restitution);
  meeting.friction = std::sqrt(A.friction * B.friction);
  meeting.time = TouchTime(meeting.A, meeting.B);
  return meeting;
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  const std::vector<int> bodies = SubjectsOf(world, claim).bodies;
  if (bodies.size() != 2)
    return {{"about", fmt::format("are {} bodies", bodies.size()), "two spheres"}};
  for (const int i : bodies) {
    const std::string why = WhyNoFreeSphere(world, i);
    if (why.empty()) continue;
    faults.push_back(FaultAbout(claim, world.bodies[static_cast<std::size_t>(i)].name,
                                why, "a free sphere"));
  }
  if (!faults.empty()) return faults;
  const SphereMeeting meeting = MeetingOf(world, bodies);
  if (!meeting.A.a_W.isApprox(meeting.B.a_W) && meeting.A.a_W != meeting.B.a_W)
    return {{"about", "have different accelerations", "the same g + F/m for both"}};
  const double r = meeting.A.radius + meeting.B.radius;
  // Written so that spheres that never meet are refused.
  if (!(meeting.time >= -kApart) ||
      (meeting.B.start.p_WB - meeting.A.start.p_WB).norm() < (1 - kApart) * r ||
      meeting.time > world.steps * world.dt)
    return {{"about",
             "are spheres that do not hit each other, or start inside each other",
             "an impact"}};
  const Outcome outcome = OutcomeOf(meeting);
  const Met& after = outcome.after;
  return FaultsOfNumbers(claim, {{"expected_first_speed", after.A.v_WB.norm()},
                                 {"expected_second_speed", after.B.v_WB.norm()},
                                 {"expected_first_spin", after.A.w_WB.norm()},
                                 {"expected_second_spin", after.B.w_WB.norm()},
                                 {"expected_energy_ratio", outcome.EnergyRatio()}});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgeMeeting(motion,
                      MeetingOf(motion.world, SubjectsOf(motion.world, claim).bodies),
                      std::numeric_limits<double>::infinity());
}

constexpr std::array<std::string_view, 5> kNumbers = {
    "expected_energy_ratio", "expected_first_speed", "expected_first_spin",
    "expected_second_speed", "expected_second_spin"};

}  // namespace

constinit const Law kSphereImpact = {
    .name = "sphere_impact",
    .documentation =
        "Two free spheres hit each other with restitution and Coulomb friction; about "
        "names "
        "both.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
