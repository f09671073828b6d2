#include <algorithm>
#include <array>
#include <string_view>

#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/falls.h"
#include "reports/worlds/law_support/landing.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

/** Returns the plane under a body or particle; empty if there is none. */
std::optional<Landing> LandingOf(const World& world, const PointMass& point) {
  if (point.on == AnchorKind::kBody) return LandingOf(world, point.index);
  std::optional<Landing> landing = LandingOfPoint(world, point.start.p_W);
  if (landing)
    landing->restitution = world.particles[static_cast<std::size_t>(point.index)].bounce;
  return landing;
}

Fall FallOf(const World& world, const PointMass& point) {
  const Landing landing = *LandingOf(world, point);
  const Eigen::Vector3d& n_W = landing.n_W;
  const double v = n_W.dot(point.start.v_W);
  const bool is_body = point.on == AnchorKind::kBody;
  return {point,
          n_W,
          {std::max(landing.gap, 0.0), v},
          -n_W.dot(point.a_W),
          landing.restitution,
          point.start.v_W - v * n_W,
          is_body ? BoundingRadius(
                        world.bodies[static_cast<std::size_t>(point.index)].placed.shape)
                  : 0};
}

/** Returns the reason why a body does not fall straight, or turns. */
std::string WhyNoStraightFall(const RigidBody& body, const Landing& landing) {
  if (!IsAlong(body.v_WB, landing.n_W) || !body.w_WB.isZero(0))
    return "does not start straight down";
  return LiesFlat(body, landing.n_W) ? "" : "does not lie flat";
}

std::string WhyNot(const World& world, const PointMass& point) {
  const bool is_body = point.on == AnchorKind::kBody;
  if (point.damping > 0) return "is damped";
  if (IsHeld(world, point.on, point.index) || (is_body && IsPushed(world, point.index)))
    return "is held or pushed";
  const std::optional<Landing> landing = LandingOf(world, point);
  if (!landing) return "is not above a static half-space or box";
  const Fall fall = FallOf(world, point);
  if (fall.gravity <= 0 || !IsAlong(point.a_W, landing->n_W))
    return "does not fall along the normal of the ground";
  if (landing->gap < 0) return "starts inside the ground";
  if (is_body) {
    return WhyNoStraightFall(world.bodies[static_cast<std::size_t>(point.index)],
                             *landing);
  }
  const std::optional<Landing> last =
      LandingOfPoint(world, point.start.p_W + world.steps * world.dt * fall.v_along_W);
  if (!last || last->ground != landing->ground)
    return "leaves the ground that it bounces on";
  return "";
}

ExpectedNumbers NumbersOfPoint(const World& world, const PointMass& point) {
  return NumbersOf(FallOf(world, point));
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachPoint(
      world, claim,
      {.why_not = WhyNot,
       .expected = "a sphere, or another shape that lies flat, falling straight onto a "
                   "static half-space or box, or a free particle above one",
       .numbers = NumbersOfPoint});
}

std::vector<Fall> FallsOf(const World& world, const Claim& claim) {
  std::vector<Fall> falls;
  for (const PointMass& point : PointMassesOf(world, SubjectsOf(world, claim)))
    falls.push_back(FallOf(world, point));
  return falls;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgeFalls(motion, FallsOf(motion.world, claim));
}

std::vector<Eigen::Vector3d> Places(const World& world, const Claim& claim,
                                    const std::vector<double>& times) {
  const Fall fall = FallsOf(world, claim).front();
  std::vector<Eigen::Vector3d> places;
  places.reserve(times.size());
  for (const double t : times) places.push_back(fall.PlaceAt(t));
  return places;
}

constexpr std::array<std::string_view, 1> kAliases = {"particle_bounce"};

}  // namespace

/** A sphere, or another body that lands flat (LiesFlat()), falls straight down onto a
 static plane and leaves each bounce with e times its speed. A particle leaves it with
 `bounce` times its normal speed, and keeps its speed along the plane
 (truth/vertical_bounces.h). [m], [-]

 The tolerances are in law_support/falls.h, with the rule that reflects the velocity after
 gravity, which is recognised.

 About: spheres and bodies that lie flat, at rest or moving along gravity, and particles
 without damping, that nothing holds, above a static half-space or box whose normal is
 opposite to gravity. Numbers, valid for all of them: expected_first_impact,
 expected_impact_speed, expected_total_time, expected_first_apex. */
constinit const Law kBounceSeries = {
    .name = "bounce_series",
    .aliases = kAliases,
    .documentation =
        "A sphere, a body that lies flat or a particle falls onto a static plane and "
        "leaves each bounce with e times its normal speed.",
    .numbers = kNumbersOfFalls,
    .faults = Faults,
    .judge = Judge,
    .places = Places,
    .has_impacts = true,
};

}  // namespace touchstone
