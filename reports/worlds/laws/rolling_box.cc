#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

/** The box, its plane and the balls on it. */
struct Train {
  int box;
  std::vector<int> balls;
  OnPlane on;
  double mass = 0;   ///< Total mass that presses on the ground. [kg]
  double moved = 0;  ///< Effective mass M + Σ m k/(1 + k). [kg]
  /** Least acceleration at which a ball begins to slip: μ_ball g (1 + k)/k. [m/s²] */
  double least_grip = 0;

  /** Returns the box's acceleration with friction bounded by `cone`. [m/s²] */
  Eigen::Vector3d Acceleration(const World& world, const PlacedCone& cone) const {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(box)];
    const double g = -world.gravity_W.dot(on.plane.n_W);
    return cone.frame * DrivenFromRest(cone.cone,
                                       cone.frame.transpose() * body.force_W / moved,
                                       on.plane.friction * mass * g / moved);
  }
};

Train TrainOf(const World& world, const Claim& claim) {
  const std::vector<int> bodies = SubjectsOf(world, claim).bodies;
  Train train{bodies.front(),
              {bodies.begin() + 1, bodies.end()},
              OnPlaneOf(world, bodies.front()),
              0,
              0,
              std::numeric_limits<double>::infinity()};
  const RigidBody& box = world.bodies[static_cast<std::size_t>(train.box)];
  train.mass = train.moved = box.mass;
  for (const int i : train.balls) {
    const RigidBody& ball = world.bodies[static_cast<std::size_t>(i)];
    const double k = InertiaRatioOf(ball);
    train.mass += ball.mass;
    train.moved += ball.mass * k / (1 + k);
    train.least_grip = std::min(
        train.least_grip, std::sqrt(ball.friction * box.friction) *
                              -world.gravity_W.dot(train.on.plane.n_W) * (1 + k) / k);
  }
  return train;
}

/** Returns the height of the lowest point of a ball above the box's upper face at the
 start, over the ball's radius; NaN if it is not above the face. */
double HeightOn(const RigidBody& box, const RigidBody& ball, const Eigen::Vector3d& n_W) {
  const Eigen::Vector3d half = std::get<Box>(box.placed.shape).half_extents;
  const Eigen::Vector3d n_B = box.placed.X_WB.R_WB.transpose() * n_W;
  const Eigen::Vector3d p_B =
      box.placed.X_WB.R_WB.transpose() * (ball.placed.X_WB.p_WB - box.placed.X_WB.p_WB);
  int up = 0;
  n_B.cwiseAbs().maxCoeff(&up);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != up && std::abs(p_B[axis]) > half[axis])
      return std::numeric_limits<double>::quiet_NaN();
  }
  return (p_B.dot(n_B) - half[up] - RadiusOf(ball)) / RadiusOf(ball);
}

std::string WhyNoBall(const World& world, const RigidBody& box, const OnPlane& on,
                      int index) {
  const RigidBody& ball = world.bodies[static_cast<std::size_t>(index)];
  if (!std::holds_alternative<Sphere>(ball.placed.shape)) return "is no sphere";
  if (!IsEvenSphere(ball)) return "has unequal moments of inertia";
  if (!ball.v_WB.isZero(0) || !ball.w_WB.isZero(0) || !ball.force_W.isZero(0))
    return "does not start at rest, or has a force of its own";
  // Written so that a ball next to the face is refused.
  if (!(std::abs(HeightOn(box, ball, on.plane.n_W)) <= 1e-3))
    return "does not start on the box";
  return "";
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  const std::vector<int> bodies = SubjectsOf(world, claim).bodies;
  const RigidBody& box = world.bodies[static_cast<std::size_t>(bodies.front())];
  std::string why = WhyNotOnPlane(world, bodies.front());
  if (why.empty() && !std::holds_alternative<Box>(box.placed.shape)) why = "is no box";
  if (why.empty() && (!box.v_WB.isZero(0) || !box.w_WB.isZero(0)))
    why = "does not start at rest";
  if (!why.empty()) {
    return {FaultAbout(claim, box.name, why, "first the box, at rest on a static plane")};
  }
  const OnPlane on = OnPlaneOf(world, bodies.front());
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const std::string why_not = WhyNoBall(world, box, on, bodies[i]);
    if (why_not.empty()) continue;
    const std::string& name = world.bodies[static_cast<std::size_t>(bodies[i])].name;
    faults.push_back(FaultAbout(claim, name, why_not, "a sphere at rest on the box"));
  }
  if (!faults.empty()) return faults;
  const Train train = TrainOf(world, claim);
  const Eigen::Vector3d a_W = train.Acceleration(world, ConesOn(on.plane.n_W).front());
  if (a_W.norm() > train.least_grip)
    return {
        {"about", "are balls that slip on the box", "enough friction for them to roll"}};
  if (train.balls.empty())
    return FaultsOfNumbers(claim, {{"expected_box_acceleration", a_W.norm()}});
  const RigidBody& ball = world.bodies[static_cast<std::size_t>(train.balls.front())];
  const double k = InertiaRatioOf(ball);
  return FaultsOfNumbers(
      claim, {{"expected_box_acceleration", a_W.norm()},
              {"expected_ball_acceleration", a_W.norm() * k / (1 + k)},
              {"expected_ball_spin_rate", a_W.norm() / ((1 + k) * RadiusOf(ball))}});
}

std::vector<Worst> JudgeBy(const PlacedCone& cone, const Motion& motion,
                           const Train& train) {
  const World& world = motion.world;
  const Eigen::Vector3d& n_W = train.on.plane.n_W;
  const Eigen::Vector3d a_W = train.Acceleration(world, cone);
  const RigidBody& box = world.bodies[static_cast<std::size_t>(train.box)];
  const double g = -world.gravity_W.dot(n_W);
  const double mu = train.on.plane.friction;
  const double pull = (box.force_W.norm() + mu * train.mass * g) / train.moved;
  const std::vector<int> moving = SubjectsOf(world, {"", {}, {}, ""}).bodies;
  // The momentum along the normal, as a velocity of the effective mass.
  const auto across_at = [&](std::size_t s) {
    double across = 0;
    for (const int index : moving) {
      const auto i = static_cast<std::size_t>(index);
      const Eigen::Vector3d& v_WB = motion.trajectory.samples[s].bodies[i].v_WB;
      across += world.bodies[i].mass * std::abs(v_WB.dot(n_W));
    }
    return across * (1 + mu) / train.moved;
  };
  const auto velocity_at = [&, across_at](std::size_t s, double ratio, double inside) {
    const double t = motion.trajectory.times[s];
    return Predicted{
        ratio * a_W * t,
        {.scheme = across_at(s) + inside * a_W.norm() * t, .solved = pull * t}};
  };
  double deepest = 0;
  std::vector<Prediction> predictions;
  for (const int index : train.balls) {
    const RigidBody& ball = world.bodies[static_cast<std::size_t>(index)];
    const double r = RadiusOf(ball);
    const double k = InertiaRatioOf(ball);
    const double inside = std::abs(HeightOn(box, ball, n_W)) +
                          2 * (g * world.dt * world.dt + train.on.Settling(world.dt)) / r;
    deepest = std::max(deepest, inside);
    predictions.push_back(
        {ball.name, StateOfBody(index), [&, r, k, inside, velocity_at](std::size_t s) {
           PredictedState predicted;
           predicted.velocity = velocity_at(s, k / (1 + k), inside);
           const double t = motion.trajectory.times[s];
           const Allowed& allowed = predicted.velocity->allowed;
           predicted.spin = {
               a_W.cross(n_W) * t / ((1 + k) * r),
               {.scheme = allowed.scheme / r, .solved = allowed.solved / r}};
           return predicted;
         }});
  }
  predictions.push_back(
      {box.name, StateOfBody(train.box), [velocity_at, deepest](std::size_t s) {
         return PredictedState{.velocity = velocity_at(s, 1, deepest)};
       }});
  const AllowedWords allowed = {
      .scheme =
          "((1 + μ) |v_n| of the bodies' own velocities along the normal, and δ/r of "
          "the velocity for a contact at depth δ in a ball)",
      .solved = "the velocity from the force and friction",
      .slop = true};
  return JudgePredictions(motion,
                          {.velocity = {allowed, "driven against friction it moves at"},
                           .spin = {allowed, "rolling on the box it spins at"}},
                          predictions);
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  return JudgedByCone(motion, {TrainOf(motion.world, claim).box},
                      [&](const PlacedCone& cone, const Motion& judged, int) {
                        Train train = TrainOf(judged.world, claim);
                        train.on.slop = judged.oracle.slop;
                        return JudgeBy(cone, judged, train);
                      });
}

constexpr std::array<std::string_view, 3> kNumbers = {
    "expected_ball_acceleration", "expected_ball_spin_rate", "expected_box_acceleration"};

}  // namespace

/** A box is driven by a force over a level plane, with balls that roll on it
 (SimBenchmark "rolling"). [m/s], [rad/s]

 Balls of mass m and inertia k m r² roll without slip: each resists the box by m a k/(1 +
 k) and moves at a k/(1 + k), so that
   a = (F − μ g (M + Σ m))/(M + Σ m k/(1 + k)),  α = a/((1 + k) r)
 along the force F, zero if friction holds it. Velocities are exact for any step, as on a
 slope (laws/incline.cc), except for δ/r of them for a contact at depth δ in a ball.

 A solver whose ground friction is a box or a diamond brakes each component on its own, or
 the larger one first; such a motion is recognised.

 About: the box first, then its balls. Numbers: expected_box_acceleration,
 expected_ball_acceleration, expected_ball_spin_rate. */
constinit const Law kRollingBox = {
    .name = "rolling_box",
    .documentation =
        "A box driven over a level plane carries balls that roll; about names the box "
        "first.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
