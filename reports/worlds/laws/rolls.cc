#include "reports/worlds/laws/rolls.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/worlds/laws/each_body.h"
#include "reports/worlds/laws/error_laws.h"
#include "reports/worlds/laws/on_plane.h"
#include "reports/worlds/laws/subjects.h"
#include "reports/worlds/laws/words.h"
#include "reports/worlds/laws/worst.h"

namespace touchstone {
namespace {

/** The share of its speed by which a sphere that rolls may slip at the start. [-] */
constexpr double kRolling = 1e-9;

double ShareOf(const RigidBody& body) {
  const double r = std::get<Sphere>(body.placed.shape).radius;
  return InertiaOf(body).x() / (body.mass * r * r);
}

std::string WhyNot(const World& world, int index) {
  std::string why = WhyNotOnPlane(world, index);
  if (!why.empty()) return why;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!IsEvenSphere(body)) return "is no sphere with equal moments of inertia";
  const OnPlane on = OnPlaneOf(world, index);
  const double r = std::get<Sphere>(body.placed.shape).radius;
  const Eigen::Vector3d slip_W = on.v_along_W - r * body.w_WB.cross(on.plane.n_W);
  if (slip_W.norm() > kRolling * (body.v_WB.norm() + r * body.w_WB.norm()))
    return "slips at the start";
  const double k = ShareOf(body);
  if (on.along_W.norm() * k / (1 + k) > on.plane.friction * on.press)
    return "has too little friction to go on rolling";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  const double k = ShareOf(world.bodies[static_cast<std::size_t>(index)]);
  return {{"expected_acceleration", OnPlaneOf(world, index).along_W.norm() / (1 + k)}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfEachBody(world, claim, WhyNot, "a sphere that rolls on a static plane",
                          NumbersOfBody);
}

std::vector<LawFinding> JudgeBody(const Motion& motion, int index) {
  const World& world = motion.world;
  const double h = world.dt;
  const auto i = static_cast<std::size_t>(index);
  const RigidBody& body = world.bodies[i];
  const OnPlane on = OnPlaneOf(world, index);
  const Eigen::Vector3d& n_W = on.plane.n_W;
  const double r = std::get<Sphere>(body.placed.shape).radius;
  const double k = ShareOf(body);
  const double mu = on.plane.friction;
  const Eigen::Vector3d a_W = on.along_W / (1 + k);
  const double pull = on.along_W.norm() + mu * on.press;
  const double inside = on.Settling(h) / r;
  const std::string because =
      "1.5 × ((1 + μ) |v_n| of the sphere's own velocity across the plane, and δ/r of "
      "the "
      "velocity for a contact δ inside), 1e-5 of the velocity for the solver, and 64 "
      "roundings a step";
  Worst velocity(MeasureKind::kVelocityError, because);
  Worst spin(MeasureKind::kSpinError, because);
  Worst position(
      MeasureKind::kPositionError,
      "1.5 × (½ a h t and what the sphere settles by), 1e-5 of the way for the "
      "solver, and 64 roundings a step");
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    const BodyState& is = motion.trajectory.samples[s].bodies[i];
    const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
    const double share = kSolverResidual + rounding;
    const Eigen::Vector3d v_W = on.v_along_W + a_W * t;
    const Eigen::Vector3d w_W = body.w_WB.dot(n_W) * n_W + n_W.cross(v_W) / r;
    const Eigen::Vector3d p_W =
        body.placed.X_WB.p_WB + on.v_along_W * t + a_W * (t * t / 2);
    const double speed = on.v_along_W.norm() + pull * t + r * body.w_WB.norm();
    const double allowed = kSafety * ((1 + mu) * on.SpeedAcross(is.v_WB, h) +
                                      inside * (v_W.norm() + r * w_W.norm())) +
                           share * speed;
    velocity.Take((is.v_WB - v_W).norm(), allowed, [&] {
      return fmt::format("{} has {} move at {} after {:.6g} s; rolling it moves at {}",
                         motion.oracle.name, body.name, Words(is.v_WB), t, Words(v_W));
    });
    spin.Take((is.w_WB - w_W).norm(), allowed / (r * std::min(1.0, k)), [&] {
      return fmt::format("{} has {} spin at {} after {:.6g} s; rolling it spins at {}",
                         motion.oracle.name, body.name, Words(is.w_WB), t, Words(w_W));
    });
    position.Take(
        (is.p_WB - p_W).norm(),
        kSafety * (a_W.norm() * h * t / 2 + on.Settling(h) + inside * speed * t) +
            share * speed * t + rounding * body.placed.X_WB.p_WB.norm(),
        [&] {
          return fmt::format("{} has {} at {} after {:.6g} s; rolling it is at {}",
                             motion.oracle.name, body.name, Words(is.p_WB), t,
                             Words(p_W));
        });
  }
  return FindingsOf({position, velocity, spin});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  std::vector<LawFinding> findings;
  for (const int i : SubjectsOf(motion.world, claim).bodies) {
    for (LawFinding& finding : JudgeBody(motion, i))
      findings.push_back(std::move(finding));
  }
  return WorstOfEach(findings);
}

}  // namespace

constinit const Law kRolls = {
    "rolls", "A sphere that rolls on a static plane goes on rolling, on slopes faster.",
    Faults, Judge};

}  // namespace touchstone
