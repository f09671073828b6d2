#include "reports/worlds/laws/oblique_impact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "reports/worlds/law_support/each_body.h"
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
  // The first root of gap + v t + ½ a t² = 0, written so that nothing cancels.
  const double gap = std::max(0.0, landing.gap);
  const double v = landing.n_W.dot(meeting.B.start.v_WB);
  const double a = landing.n_W.dot(meeting.B.a_W);
  const double V = std::sqrt(v * v - 2 * a * gap);
  meeting.time = v < 0 || a < 0 ? (v < 0 ? 2 * gap / (V - v) : -(v + V) / a)
                                : std::numeric_limits<double>::quiet_NaN();
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
  const PlacedCone circle = ConesOn(*meeting.n_AB_W).front();
  const Striker before = MetAt(meeting, meeting.time, meeting.time, 0, circle).B;
  const Striker after =
      MetAt(meeting, std::nextafter(meeting.time, 1e300), meeting.time, 0, circle).B;
  const auto energy = [](const Striker& is) {
    return is.v_WB.squaredNorm() / is.inverse_mass +
           is.w_WB.squaredNorm() / is.inverse_inertia_W(0, 0);
  };
  const double v_n = after.v_WB.dot(*meeting.n_AB_W);
  return {{"expected_normal_speed", std::abs(v_n)},
          {"expected_tangential_speed", (after.v_WB - v_n * *meeting.n_AB_W).norm()},
          {"expected_spin", after.w_WB.norm()},
          {"expected_energy_ratio", energy(after) / energy(before)}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfOneBody(world, claim, "one sphere", WhyNot,
                         "a sphere that flies against a static half-space or box",
                         NumbersOfBody);
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
