#include "reports/worlds/laws/incline.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/at_sample.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/flat_box.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/slop.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** Initial acceleration of a body from rest. */
struct Start {
  Eigen::Vector3d a_W;      ///< [m/s²]
  Eigen::Vector3d alpha_W;  ///< [rad/s²]
};

Start StartOf(const RigidBody& body, const OnPlane& on, const PlacedCone& cone) {
  const double brake = on.plane.friction * on.press;
  if (!std::holds_alternative<Sphere>(body.placed.shape)) {
    return {cone.frame *
                DrivenFromRest(cone.cone, cone.frame.transpose() * on.along_W, brake),
            Eigen::Vector3d::Zero()};
  }
  // Friction f at the contact: a = a_t + f, α = (−r n) × f m/I; rolling leaves no slip.
  const double r = RadiusOf(body);
  const double k = InertiaRatioOf(body);
  const Eigen::Vector3d holding_W = -on.along_W * k / (1 + k);
  const Eigen::Vector3d f_W =
      cone.frame * NearestInCone(cone.cone, cone.frame.transpose() * holding_W, brake);
  return {on.along_W + f_W, -on.plane.n_W.cross(f_W) / (k * r)};
}

std::string WhyNot(const World& world, int index) {
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!body.v_WB.isZero(0) || !body.w_WB.isZero(0)) return "does not start at rest";
  if (IsEvenSphere(body)) return "";
  if (!std::holds_alternative<Box>(body.placed.shape))
    return "is neither a box nor a sphere with equal moments of inertia";
  const OnPlane on = OnPlaneOf(world, index);
  if (Tips(body, on, std::min(on.plane.friction * on.press, on.along_W.norm())))
    return "is so tall that friction tips it";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  const OnPlane on = OnPlaneOf(world, index);
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const Start start = StartOf(body, on, ConesOn(on.plane.n_W).front());
  return {{"expected_acceleration", start.a_W.norm()}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(world, claim,
                          {.why_not = WhyNot,
                           .expected = "a flat box or a sphere at rest on a static plane",
                           .numbers = NumbersOfBody});
}

std::vector<Worst> JudgeBy(const PlacedCone& cone, const Motion& motion, int index) {
  const World& world = motion.world;
  const double h = world.dt;
  const auto i = static_cast<std::size_t>(index);
  const RigidBody& body = world.bodies[i];
  const OnPlane on = OnPlaneOf(motion, index);
  const double mu = on.plane.friction;
  const Start start = StartOf(body, on, cone);
  const double pull = on.along_W.norm() + mu * on.press;
  const double r = BoundingRadius(body.placed.shape);
  std::optional<FlatBox> flat;
  if (std::holds_alternative<Box>(body.placed.shape)) flat.emplace(motion, index, on);
  const std::string here = fmt::format("on this slope with μ = {:.6g} it ", mu);
  const std::string because = WithSlop(
      "1.5 × ((1 + μ) |v_n| of the body's own velocity along the normal, and δ/r of the "
      "velocity for a contact at depth δ), 1e-5 of the velocity from gravity and "
      "friction for the solver, and 64 roundings per step",
      motion.oracle);
  Worst velocity(MeasureKind::kVelocityError, because);
  Worst spin(MeasureKind::kSpinError, because);
  Worst position(MeasureKind::kPositionError,
                 WithSlop("1.5 × (½ a h t and the settling distance), 1e-5 of the "
                          "distance from gravity and friction for the solver, and 64 "
                          "roundings per step",
                          motion.oracle));
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    const AtSample at{motion, s, body.name};
    const BodyState& is = motion.trajectory.samples[s].bodies[i];
    const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
    const double share = kSolverResidual + rounding;
    const double across = (1 + mu) * on.SpeedAcross(is.v_WB, h);
    const double inside = on.Settling(h) / r;
    const Eigen::Vector3d v_W = start.a_W * t;
    at.Compare(velocity, is.v_WB, v_W,
               kSafety * (across + inside * v_W.norm()) + share * pull * t,
               here + "moves at");
    const Eigen::Vector3d p_W = body.placed.X_WB.p_WB + v_W * (t / 2);
    at.Compare(position, is.p_WB, p_W,
               kSafety * (v_W.norm() * (h + inside * t) / 2 + on.Settling(h)) +
                   share * pull * t * t / 2 + rounding * body.placed.X_WB.p_WB.norm(),
               here + "is at");
    if (flat) {
      flat->Take(s, pull * t);
      continue;
    }
    const Eigen::Vector3d w_W = start.alpha_W * t;
    at.Compare(spin, is.w_WB, w_W,
               kSafety * (across / r + inside * w_W.norm()) + share * pull * t / r,
               here + "spins at");
  }
  if (flat) return {position, velocity, flat->orientation(), flat->spin()};
  return {position, velocity, spin};
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgedByCone(motion, SubjectsOf(motion.world, claim).bodies, JudgeBy);
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_acceleration"};

}  // namespace

constinit const Law kIncline = {
    .name = "incline",
    .documentation =
        "From rest on a slope, a box stays if μ >= tan θ, else "
        "slides, and never rotates; a sphere rolls or slips.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
