#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/landing.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/sphere_meeting.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

/** Overlap at the start that counts as rounding, over the sum of the radii. [-] */
constexpr double kApart = 1e-9;

SphereMeeting MeetingOfTwo(const World& world, int a, int b) {
  const RigidBody& A = world.bodies[static_cast<std::size_t>(a)];
  const RigidBody& B = world.bodies[static_cast<std::size_t>(b)];
  SphereMeeting meeting;
  meeting.A = SideOf(world, a);
  meeting.B = SideOf(world, b);
  meeting.restitution = std::min(A.restitution, B.restitution);
  meeting.friction = std::sqrt(A.friction * B.friction);
  meeting.time = TouchTime(meeting.A, meeting.B);
  return meeting;
}

SphereMeeting MeetingWithGround(const World& world, int index) {
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

SphereMeeting MeetingOf(const World& world, const std::vector<int>& bodies) {
  return bodies.size() == 2 ? MeetingOfTwo(world, bodies[0], bodies[1])
                            : MeetingWithGround(world, bodies.front());
}

/** Returns the time at which a sphere comes down on the ground again, less three steps by
 which an engine may be early; never for two spheres. [s] */
double SecondImpact(const World& world, const SphereMeeting& meeting) {
  if (!meeting.n_AB_W) return std::numeric_limits<double>::infinity();
  const double a = meeting.n_AB_W->dot(meeting.B.a_W);
  if (a >= 0) return std::numeric_limits<double>::infinity();
  const double V =
      -meeting.n_AB_W->dot(meeting.B.start.v_WB + meeting.time * meeting.B.a_W);
  return meeting.time + 2 * meeting.restitution * V / -a - 3 * world.dt;
}

std::vector<Fault> FaultsOfTwo(const World& world, const Claim& claim, int a, int b) {
  std::vector<Fault> faults;
  for (const int i : {a, b}) {
    const std::string why = WhyNoFreeSphere(world, i);
    if (why.empty()) continue;
    faults.push_back(FaultAbout(claim, world.bodies[static_cast<std::size_t>(i)].name,
                                why, "a free sphere"));
  }
  if (!faults.empty()) return faults;
  const SphereMeeting meeting = MeetingOfTwo(world, a, b);
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
  const BothSides& after = outcome.after;
  return FaultsOfNumbers(claim, {{"expected_first_speed", after.A.v_WB.norm()},
                                 {"expected_second_speed", after.B.v_WB.norm()},
                                 {"expected_first_spin", after.A.w_WB.norm()},
                                 {"expected_second_spin", after.B.w_WB.norm()},
                                 {"expected_energy_ratio", outcome.EnergyRatio()}});
}

std::string WhyNotAgainstGround(const World& world, int index) {
  std::string why = WhyNoFreeSphere(world, index);
  if (!why.empty()) return why;
  const std::optional<Landing> landing = LandingOf(world, index);
  if (!landing) return "faces no static half-space or box";
  if (landing->gap < -kApart * SideOf(world, index).radius)
    return "starts inside the ground";
  const SphereMeeting meeting = MeetingWithGround(world, index);
  // Written so that a sphere that never arrives is refused.
  if (!(meeting.time <= world.steps * world.dt)) return "does not reach the ground";
  if (SecondImpact(world, meeting) <= meeting.time)
    return "hits the ground again within three steps";
  return "";
}

ExpectedNumbers NumbersAgainstGround(const World& world, int index) {
  const SphereMeeting meeting = MeetingWithGround(world, index);
  const Outcome outcome = OutcomeOf(meeting);
  const Striker& after = outcome.after.B;
  const double v_n = after.v_WB.dot(*meeting.n_AB_W);
  return {{"expected_normal_speed", std::abs(v_n)},
          {"expected_tangential_speed", (after.v_WB - v_n * *meeting.n_AB_W).norm()},
          {"expected_spin", after.w_WB.norm()},
          {"expected_energy_ratio", outcome.EnergyRatio()}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  const std::vector<int> bodies = SubjectsOf(world, claim).bodies;
  if (bodies.size() != 2) {
    return FaultsOfOneBody(
        world, claim, "one sphere or two",
        {.why_not = WhyNotAgainstGround,
         .expected = "a sphere that flies against a static half-space or box",
         .numbers = NumbersAgainstGround});
  }
  const std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  return faults.empty() ? FaultsOfTwo(world, claim, bodies[0], bodies[1]) : faults;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const SphereMeeting meeting =
      MeetingOf(motion.world, SubjectsOf(motion.world, claim).bodies);
  return JudgeMeeting(motion, meeting, SecondImpact(motion.world, meeting));
}

constexpr std::array<std::string_view, 1> kAliases = {"oblique_impact"};
constexpr std::array<std::string_view, 8> kNumbers = {
    "expected_energy_ratio", "expected_first_speed",     "expected_first_spin",
    "expected_normal_speed", "expected_second_speed",    "expected_second_spin",
    "expected_spin",         "expected_tangential_speed"};

}  // namespace

/** Two free spheres with spins hit each other at any angle, or one hits a static plane.
 [m/s], [rad/s], [m], [-]

 J_n = (1 + e) |u_n|/(Σ 1/m). J_t ends the slip u_t, −u_t/(Σ 1/m + r²/I), if that is at
 most μ J_n; else it has that magnitude (hard spheres: Walton & Braun, J. Rheol. 30 (1986)
 949, with β₀ = 0; for central impacts Newton's, Poisson's and Stronge's restitution
 agree). So on a plane v_n' = −e v_n, and the slip of a solid sphere ends if μ >= (2/7)
 |u_t|/((1 + e) |v_n|): v_t' = v_t − (2/7) u_t. Else v_t' = v_t − μ (1 + e) |v_n| û, Δω =
 (5/2) μ (1 + e) |v_n|/r (Foerster et al., Phys. Fluids 6 (1994) 1108). The tolerance is
 that of law_support/sphere_meeting.h. Other friction cones are recognised. Under gravity
 a sphere is judged until it comes down on the plane again.

 About: the two spheres; or one, in free flight at the start. Numbers of two:
 expected_first_speed, expected_second_speed, expected_first_spin, expected_second_spin;
 of one: expected_normal_speed, expected_tangential_speed, expected_spin (magnitudes,
 after the impact); of both: expected_energy_ratio (kinetic energy after to before). */
constinit const Law kSphereImpact = {
    .name = "sphere_impact",
    .aliases = kAliases,
    .documentation =
        "Two free spheres hit each other, or one hits a static plane, with restitution "
        "and "
        "Coulomb friction; about names both, or the one.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
