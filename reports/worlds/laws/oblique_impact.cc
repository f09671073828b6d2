#include "reports/worlds/laws/oblique_impact.h"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/landing.h"
#include "reports/worlds/law_support/sphere_meeting.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** Overlap at the start that counts as rounding, over the radius. [-] */
constexpr double kApart = 1e-9;

SphereMeeting MeetingOf(const World& world, int index) {
  const Landing landing = *LandingOf(world, index);
  SphereMeeting meeting;
  meeting.A.body = landing.ground;
  meeting.A.start.p_WB = landing.p_WC - landing.gap * landing.n_W;
  meeting.B = SideOf(world, index);
  meeting.n_AB_W = landing.n_W;
  meeting.restitution = landing.restitution;
  meeting.friction = landing.friction;
  meeting.time = ArrivalAt(landing, meeting.B.start.v_WB, meeting.B.a_W).time;
  return meeting;
}

/** Returns the time at which the sphere comes down again, less three steps by which an
 engine may be early. [s] */
double SecondImpact(const World& world, const SphereMeeting& meeting) {
  const double a = meeting.n_AB_W->dot(meeting.B.a_W);
  if (a >= 0) return std::numeric_limits<double>::infinity();
  const double V =
      -meeting.n_AB_W->dot(meeting.B.start.v_WB + meeting.time * meeting.B.a_W);
  return meeting.time + 2 * meeting.restitution * V / -a - 3 * world.dt;
}

std::string WhyNot(const World& world, int index) {
  std::string why = WhyNoFreeSphere(world, index);
  if (!why.empty()) return why;
  const std::optional<Landing> landing = LandingOf(world, index);
  if (!landing) return "faces no static half-space or box";
  if (landing->gap < -kApart * SideOf(world, index).radius)
    return "starts inside the ground";
  const SphereMeeting meeting = MeetingOf(world, index);
  // Written so that a sphere that never arrives is refused.
  if (!(meeting.time <= world.steps * world.dt)) return "does not reach the ground";
  if (SecondImpact(world, meeting) <= meeting.time)
    return "hits the ground again within three steps";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  const SphereMeeting meeting = MeetingOf(world, index);
  const Outcome outcome = OutcomeOf(meeting);
  const Striker& after = outcome.after.B;
  const double v_n = after.v_WB.dot(*meeting.n_AB_W);
  return {{"expected_normal_speed", std::abs(v_n)},
          {"expected_tangential_speed", (after.v_WB - v_n * *meeting.n_AB_W).norm()},
          {"expected_spin", after.w_WB.norm()},
          {"expected_energy_ratio", outcome.EnergyRatio()}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfOneBody(
      world, claim, "one sphere",
      {.why_not = WhyNot,
       .expected = "a sphere that flies against a static half-space or box",
       .numbers = NumbersOfBody});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const SphereMeeting meeting =
      MeetingOf(motion.world, SubjectsOf(motion.world, claim).bodies.front());
  return JudgeMeeting(motion, meeting, SecondImpact(motion.world, meeting));
}

constexpr std::array<std::string_view, 4> kNumbers = {
    "expected_energy_ratio", "expected_normal_speed", "expected_spin",
    "expected_tangential_speed"};

}  // namespace

constinit const Law kObliqueImpact = {
    .name = "oblique_impact",
    .documentation =
        "A sphere hits a static plane at an angle, with spin, restitution and Coulomb "
        "friction.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
