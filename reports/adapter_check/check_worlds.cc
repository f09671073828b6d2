#include "reports/adapter_check/check_worlds.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/adapter_check/world_mistakes.h"

namespace touchstone {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/** A world in which a few mistakes show. */
struct Trial {
  std::string what;
  World world;
};

// Nothing in these worlds is along an axis, at the origin or of equal sizes, so that no
// mistake goes unseen.
RigidBody Mover(const Shape& shape) {
  RigidBody body;
  body.name = "mover";
  body.placed = {shape,
                 Pose::FromQuaternion({0.3, 2, -0.7},
                                      Quaterniond(0.7, -0.3, 0.5, 0.4).normalized())};
  body.mass = 2;
  body.v_WB = {1.5, 2, -1};
  body.w_WB = {2, -1.5, 2.5};
  return body;
}

World Free(const Shape& shape) {
  World world;
  world.bodies.push_back(Mover(shape));
  world.gravity_W.setZero();
  world.steps = 120;
  world.sample_every = 10;
  return world;
}

const Box kBox{{0.1, 0.2, 0.4}};

std::vector<Trial> Trials() {
  std::vector<Trial> trials;
  for (const auto& [shape, name] :
       {std::pair(Shape(Sphere{0.25}), "ball"), std::pair(Shape(kBox), "box")}) {
    World thrown = Free(shape);
    thrown.gravity_W = {1, -9.5, 2};
    // About a principal axis of the box, so that its spin stays as it is.
    thrown.bodies[0].w_WB = thrown.bodies[0].placed.X_WB.R_WB * Vector3d(0, 0, 3);
    trials.push_back({fmt::format("a {} is thrown", name), thrown});
  }
  trials.push_back({"a box spins without torque", Free(kBox)});
  World pushed = Free(kBox);
  pushed.bodies[0].v_WB.setZero();
  pushed.bodies[0].w_WB.setZero();
  pushed.pushes.push_back({0, 60 * pushed.dt, {0.05, -0.1, 0.3}, {1, 2, -0.5}});
  trials.push_back({"a box is pushed off its centre", pushed});
  return trials;
}

/** How two motions differ: the largest of four relative differences. */
struct Difference {
  double value = 0;
  std::string words;
};

double AngleBetween(const Quaterniond& a, const Quaterniond& b) {
  return a.normalized().angularDistance(b.normalized());
}

// The sizes of a motion, by which differences are divided.
struct Scale {
  double length;  // [m]
  double angle;   // [rad]
  double speed;   // [m/s]
  double spin;    // [rad/s]
};

Scale ScaleOf(const Trajectory& motion) {
  const BodyState& start = motion.samples.front().bodies[0];
  Scale scale{0.1, 0.1, 0.1, 0.1};
  for (const WorldState& sample : motion.samples) {
    const BodyState& body = sample.bodies[0];
    scale.length = std::max(scale.length, (body.p_WB - start.p_WB).norm());
    scale.angle = std::max(scale.angle, AngleBetween(body.q_WB, start.q_WB));
    scale.speed = std::max(scale.speed, body.v_WB.norm());
    scale.spin = std::max(scale.spin, body.w_WB.norm());
  }
  return scale;
}

Difference DifferenceOf(const Trajectory& motion, const Trajectory& right) {
  const Scale scale = ScaleOf(right);
  Difference worst;
  const auto take = [&](double value, double unit, double time, const char* what) {
    if (value / unit <= worst.value) return;
    worst.value = value / unit;
    worst.words = fmt::format("after {:.3g} s {} off by {:.2g}", time, what, value);
  };
  for (std::size_t i = 0; i < right.samples.size(); ++i) {
    const double t = right.times[i];
    if (i >= motion.samples.size())
      return {HUGE_VAL, fmt::format("the motion ends before {:.3g} s", t)};
    const BodyState& is = motion.samples[i].bodies[0];
    const double length = is.q_WB.coeffs().stableNorm();
    // Written so that a NaN is not right.
    if (!(std::abs(length - 1) <= 1e-3))
      return {HUGE_VAL,
              fmt::format("after {:.3g} s the length of its quaternion is {:.3g}", t,
                          length)};
    const BodyState& should = right.samples[i].bodies[0];
    take((is.p_WB - should.p_WB).norm(), scale.length, t, "the position [m] is");
    take(AngleBetween(is.q_WB, should.q_WB), scale.angle, t, "the orientation [rad] is");
    take((is.v_WB - should.v_WB).norm(), scale.speed, t, "the velocity [m/s] is");
    take((is.w_WB - should.w_WB).norm(), scale.spin, t, "the spin [rad/s] is");
  }
  return worst;
}

std::vector<std::string> MistakesThatExplain(const Trajectory& motion, const World& world,
                                             const Oracle& reference) {
  std::vector<std::string> sentences;
  for (const WorldMistake& mistake : WorldMistakes()) {
    World simulated = world;
    if (mistake.simulated) {
      const std::optional<World> other = mistake.simulated(world);
      if (!other) continue;
      simulated = *other;
    }
    Trajectory meant = motion;
    if (mistake.undo) mistake.undo(world, meant);
    const Trajectory right = reference.Simulate(simulated);
    if (right.status != AnswerStatus::kAnswered) continue;
    if (DifferenceOf(meant, right).value <= kSameMotion)
      sentences.push_back(mistake.sentence);
  }
  return sentences;
}

WorldCheck CheckOne(const Trial& trial, const Oracle& oracle, const Oracle& reference) {
  WorldCheck check{trial.what, oracle.CannotSimulate(trial.world), "", {}};
  if (!check.reason.empty()) return check;
  const Trajectory motion = oracle.Simulate(trial.world);
  if (motion.status == AnswerStatus::kUnsupported) {
    check.reason = motion.reason;
    return check;
  }
  if (motion.status != AnswerStatus::kAnswered) {
    check.wrong = motion.reason;
    return check;
  }
  const Difference difference = DifferenceOf(motion, reference.Simulate(trial.world));
  if (difference.value <= kSameMotion) return check;
  check.wrong = difference.words;
  check.mistakes = MistakesThatExplain(motion, trial.world, reference);
  return check;
}

}  // namespace

std::vector<WorldCheck> CheckWorlds(const Oracle& oracle, const Oracle& reference) {
  std::vector<WorldCheck> checks;
  if (!oracle.info().simulates) return checks;
  for (const Trial& trial : Trials())
    checks.push_back(CheckOne(trial, oracle, reference));
  return checks;
}

}  // namespace touchstone
