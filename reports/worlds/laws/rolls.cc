#include <array>
#include <string_view>

#include "reports/worlds/law_support/ball_on_plane.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

/** Largest initial slip of a rolling body, over its speed. [-] */
constexpr double kRolling = 1e-9;

std::string WhyNot(const World& world, int index) {
  std::string why = WhyNoRollerOnPlane(world, index);
  if (!why.empty()) return why;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const OnPlane on = OnPlaneOf(world, index);
  const double r = RadiusOf(body);
  const Eigen::Vector3d slip_W = on.v_along_W - r * body.w_WB.cross(on.plane.n_W);
  if (slip_W.norm() > kRolling * (body.v_WB.norm() + r * body.w_WB.norm()))
    return "slips at the start";
  const double k = InertiaRatioOf(body);
  if (on.along_W.norm() * k / (1 + k) > on.plane.friction * on.press)
    return "has too little friction to keep rolling";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  const double k = InertiaRatioOf(world.bodies[static_cast<std::size_t>(index)]);
  return {{"expected_acceleration", OnPlaneOf(world, index).along_W.norm() / (1 + k)}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(
      world, claim,
      {.why_not = WhyNot,
       .expected = "a sphere, or a capsule or cylinder on its side, that rolls on "
                   "a static plane",
       .numbers = NumbersOfBody});
}

std::vector<LawFinding> JudgeBody(const Motion& motion, int index) {
  const RigidBody& body = motion.world.bodies[static_cast<std::size_t>(index)];
  const OnPlane on = OnPlaneOf(motion, index);
  const Eigen::Vector3d& n_W = on.plane.n_W;
  const double r = RadiusOf(body);
  const Eigen::Vector3d a_W = on.along_W / (1 + InertiaRatioOf(body));
  const double pull = on.along_W.norm() + on.plane.friction * on.press;
  const auto truth_at = [&](double t) {
    BodyState truth;
    truth.v_WB = on.v_along_W + a_W * t;
    truth.w_WB = body.w_WB.dot(n_W) * n_W + n_W.cross(truth.v_WB) / r;
    truth.p_WB = body.placed.X_WB.p_WB + on.v_along_W * t + a_W * (t * t / 2);
    return truth;
  };
  const auto errors_at = [&](double t) {
    const BodyState truth = truth_at(t);
    return BallErrors{on.v_along_W.norm() + pull * t + r * body.w_WB.norm(),
                      truth.v_WB.norm() + r * truth.w_WB.norm(), 0,
                      a_W.norm() * motion.world.dt * t / 2};
  };
  const BallWords words = {
      .how = "rolling",
      .velocity = {.scheme =
                       "((1 + μ) |v_n| of the body's own velocity along the normal, "
                       "and δ/r of the velocity for a contact at depth δ)",
                   .solved = "the velocity",
                   .slop = true},
      .position = {.scheme = "(½ a h t and the settling distance)",
                   .solved = "the distance",
                   .slop = true}};
  return FindingsOf(JudgeBall(motion, index, on, words, {truth_at, errors_at}));
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return WorstOfEach(SubjectsOf(motion.world, claim).bodies,
                     [&](int body) { return JudgeBody(motion, body); });
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_acceleration"};

}  // namespace

/** A sphere, or a capsule or cylinder on its side, that rolls on a static plane keeps
 rolling. Its acceleration along the plane
 is a = a_t/(1 + k), where a_t is the part of gravity and force along the plane and k m r²
 the inertia. So v = v₀ + a t and ω = n × v/r, and the spin about the normal is constant.
 [m/s], [rad/s], [m]

 Friction supplies k/(1 + k) |a_t|, at most μ a_n. The tolerances are those of a slope
 (laws/incline.cc).

 About: spheres, and capsules and cylinders that move across their axis, that start
 rolling, to 1e-9 of their speed. Numbers:
 expected_acceleration. */
constinit const Law kRolls = {
    .name = "rolls",
    .documentation =
        "A sphere, or a capsule or cylinder on its side, that rolls on a static plane "
        "keeps "
        "rolling; a slope accelerates it.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
