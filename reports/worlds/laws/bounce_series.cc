#include "reports/worlds/laws/bounce_series.h"

#include <algorithm>

#include "reports/worlds/law_support/each_body.h"
#include "reports/worlds/law_support/falls.h"
#include "reports/worlds/law_support/landing.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** Largest angle of a face to the plane it lands on; quaternions have 16 digits. [rad] */
constexpr double kFlat = 1e-9;

Fall FallOf(const World& world, int index) {
  const Landing landing = *LandingOf(world, index);
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const Eigen::Vector3d a_W = world.gravity_W + body.force_W / body.mass;
  return {body.name,
          landing.n_W,
          {std::max(landing.gap, 0.0), landing.n_W.dot(body.v_WB)},
          -landing.n_W.dot(a_W),
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
  if (!landing) return "is no sphere or box above a static half-space or box";
  const Fall fall = FallOf(world, index);
  const Eigen::Vector3d a_W = world.gravity_W + body.force_W / body.mass;
  if (fall.gravity <= 0 || !IsAlong(a_W, landing->n_W))
    return "does not fall along the normal of the ground";
  if (!IsAlong(body.v_WB, landing->n_W) || !body.w_WB.isZero(0))
    return "does not start straight down";
  if (landing->gap < 0) return "starts inside the ground";
  if (std::holds_alternative<Box>(body.placed.shape)) {
    const Eigen::Vector3d n_B = body.placed.X_WB.R_WB.transpose() * landing->n_W;
    if (n_B.cwiseAbs().maxCoeff() < 1 - kFlat) return "is a box that does not lie flat";
  }
  if (IsHeld(world, AnchorKind::kBody, index) || IsPushed(world, index))
    return "is held or pushed";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  return NumbersOf(FallOf(world, index));
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(world, claim, WhyNot,
                          "a sphere, or a box that lies flat, falling straight onto a "
                          "static half-space or box",
                          NumbersOfBody);
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const std::vector<int> bodies = SubjectsOf(motion.world, claim).bodies;
  std::vector<Fall> falls;
  falls.reserve(bodies.size());
  for (const int i : bodies) falls.push_back(FallOf(motion.world, i));
  return JudgeFalls(motion, falls);
}

Eigen::Vector3d Place(const World& world, const Claim& claim, double t) {
  return FallOf(world, SubjectsOf(world, claim).bodies.front()).PlaceAt(t);
}

}  // namespace

constinit const Law kBounceSeries = {
    .name = "bounce_series",
    .documentation =
        "A sphere or a flat box falls straight onto a static plane and leaves each "
        "bounce "
        "with e times its speed.",
    .numbers = kNumbersOfFalls,
    .faults = Faults,
    .judge = Judge,
    .place = Place,
    .has_impacts = true,
};

}  // namespace touchstone
