#include "reports/worlds/laws/rolls.h"

#include <array>
#include <string_view>

#include "reports/worlds/law_support/ball_on_plane.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"

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
  const World& world = motion.world;
  const double h = world.dt;
  const auto i = static_cast<std::size_t>(index);
  const RigidBody& body = world.bodies[i];
  const OnPlane on = OnPlaneOf(motion, index);
  const Eigen::Vector3d& n_W = on.plane.n_W;
  const double r = RadiusOf(body);
  const double k = InertiaRatioOf(body);
  const Eigen::Vector3d a_W = on.along_W / (1 + k);
  const double pull = on.along_W.norm() + on.plane.friction * on.press;
  BallOnPlane ball(motion, index, on, "rolling",
                   "1.5 × ((1 + μ) |v_n| of the body's own velocity along the normal, "
                   "and δ/r of the velocity for a contact at depth δ), 1e-5 of the "
                   "velocity for the solver, and 64 roundings per step",
                   "1.5 × (½ a h t and the settling distance), 1e-5 of the distance for "
                   "the solver, and 64 roundings per step");
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    BodyState truth;
    truth.v_WB = on.v_along_W + a_W * t;
    truth.w_WB = body.w_WB.dot(n_W) * n_W + n_W.cross(truth.v_WB) / r;
    truth.p_WB = body.placed.X_WB.p_WB + on.v_along_W * t + a_W * (t * t / 2);
    const double speed = on.v_along_W.norm() + pull * t + r * body.w_WB.norm();
    ball.Take(
        s, truth,
        {speed, truth.v_WB.norm() + r * truth.w_WB.norm(), 0, a_W.norm() * h * t / 2});
  }
  return FindingsOf(ball.Findings());
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return WorstOfEach(SubjectsOf(motion.world, claim).bodies,
                     [&](int body) { return JudgeBody(motion, body); });
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_acceleration"};

}  // namespace

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
