#include "reports/worlds/laws/bounce_series.h"

#include <algorithm>

#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/falls.h"
#include "reports/worlds/law_support/landing.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

Fall FallOf(const World& world, int index) {
  const Landing landing = *LandingOf(world, index);
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  return {body.name,
          landing.n_W,
          {std::max(landing.gap, 0.0), landing.n_W.dot(body.v_WB)},
          -landing.n_W.dot(AccelerationOf(world, body)),
          landing.restitution,
          body.placed.X_WB.p_WB,
          Eigen::Vector3d::Zero(),
          BoundingRadius(body.placed.shape),
          [index](const WorldState& state) {
            const BodyState& is = state.bodies[static_cast<std::size_t>(index)];
            return PointState{is.p_WB, is.v_WB};
          }};
}

std::string WhyNot(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const std::optional<Landing> landing = LandingOf(world, index);
  if (!landing) return "is not above a static half-space or box";
  const Fall fall = FallOf(world, index);
  if (fall.gravity <= 0 || !IsAlong(AccelerationOf(world, body), landing->n_W))
    return "does not fall along the normal of the ground";
  if (!IsAlong(body.v_WB, landing->n_W) || !body.w_WB.isZero(0))
    return "does not start straight down";
  if (landing->gap < 0) return "starts inside the ground";
  if (!LiesFlat(body, landing->n_W)) return "does not lie flat";
  if (IsHeld(world, AnchorKind::kBody, index) || IsPushed(world, index))
    return "is held or pushed";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  return NumbersOf(FallOf(world, index));
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(
      world, claim,
      {.why_not = WhyNot,
       .expected = "a sphere, or another shape that lies flat, falling straight onto a "
                   "static half-space or box",
       .numbers = NumbersOfBody});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgeFalls(motion, SubjectsOf(motion.world, claim).bodies, FallOf);
}

Eigen::Vector3d Place(const World& world, const Claim& claim, double t) {
  return FallOf(world, SubjectsOf(world, claim).bodies.front()).PlaceAt(t);
}

}  // namespace

constinit const Law kBounceSeries = {
    .name = "bounce_series",
    .documentation =
        "A sphere, or a body that lies flat, falls straight onto a static plane and "
        "leaves "
        "each bounce with e times its speed.",
    .numbers = kNumbersOfFalls,
    .faults = Faults,
    .judge = Judge,
    .place = Place,
    .has_impacts = true,
};

}  // namespace touchstone
