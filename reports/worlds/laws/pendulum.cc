#include "reports/worlds/laws/pendulum.h"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/held_by_rods.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/pendulum.h"

namespace touchstone {
namespace {

/** Part of a speed that may be across the plane of the swing or along the rod. [-] */
constexpr double kInPlane = 1e-9;

/** Smallest 1 + cos θ at which a mass at rest does not count as balanced above its pivot.
 [-] */
constexpr double kOnHead = 1e-6;

/** A pendulum at p + L (sin θ x̂ + cos θ ĝ). */
struct Swinging {
  HeldByRods held;
  Eigen::Vector3d p_W;
  Eigen::Vector3d x_W;
  Eigen::Vector3d down_W;
  double length;
  double omega;
  PendulumAngle start;
};

Swinging SwingingOf(const World& world, const std::vector<PointMass>& points) {
  Swinging swinging;
  swinging.held = ChainOf(world, points);
  const Rod& rod = swinging.held.system.rods.front();
  const PointState& start = points.front().start;
  const Eigen::Vector3d arm_W = start.p_W - rod.p_W;
  swinging.p_W = rod.p_W;
  swinging.length = arm_W.norm();
  swinging.down_W = world.gravity_W.normalized();
  swinging.omega = std::sqrt(world.gravity_W.norm() / swinging.length);
  const auto across = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(v - v.dot(swinging.down_W) * swinging.down_W);
  };
  // If it hangs straight down, its velocity determines the plane.
  const Eigen::Vector3d side_W = across(arm_W);
  swinging.x_W = side_W.norm() > kInPlane * swinging.length
                     ? side_W.normalized()
                     : across(start.v_W).normalized();
  const double sine = arm_W.dot(swinging.x_W);
  const double cosine = arm_W.dot(swinging.down_W);
  const Eigen::Vector3d tangent_W =
      (cosine * swinging.x_W - sine * swinging.down_W) / swinging.length;
  swinging.start = {std::atan2(sine, cosine), start.v_W.dot(tangent_W) / swinging.length};
  return swinging;
}

std::string WhyNot(const World& world, const std::vector<PointMass>& points) {
  if (points.size() != 1) return fmt::format("are {} bodies or particles", points.size());
  if (world.gravity_W.isZero(0)) return "is in a world without gravity";
  std::string why = WhyNoChain(world, points);
  if (!why.empty()) return why;
  const Swinging swinging = SwingingOf(world, points);
  const Eigen::Vector3d& v_W = points.front().start.v_W;
  const Eigen::Vector3d arm_W = points.front().start.p_W - swinging.p_W;
  const Eigen::Vector3d across_W = swinging.x_W.cross(swinging.down_W);
  if (std::abs(v_W.dot(across_W)) > kInPlane * v_W.norm() ||
      std::abs(v_W.dot(arm_W)) > kInPlane * v_W.norm() * swinging.length)
    return "does not start along a circle in a vertical plane";
  if (1 + std::cos(swinging.start.theta) < kOnHead && v_W.isZero(0))
    return "is balanced above its pivot";
  return "";
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  const std::vector<PointMass> points = PointMassesInOrder(world, claim);
  const std::string why = WhyNot(world, points);
  if (!why.empty())
    return {{"about", why, "a mass on one rod to a fixed point, swinging in a plane"}};
  const Swinging swinging = SwingingOf(world, points);
  return FaultsOfNumbers(
      claim, {{"expected_period", Pendulum(swinging.omega, swinging.start).period()}});
}

/** Returns the state of the mass at an angle of its swing. */
PointState At(const Swinging& swinging, const PendulumAngle& angle) {
  const double sine = std::sin(angle.theta);
  const double cosine = std::cos(angle.theta);
  const Eigen::Vector3d& x_W = swinging.x_W;
  const Eigen::Vector3d& down_W = swinging.down_W;
  return {swinging.p_W + swinging.length * (sine * x_W + cosine * down_W),
          swinging.length * angle.rate * (cosine * x_W - sine * down_W)};
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const Swinging swinging =
      SwingingOf(motion.world, PointMassesInOrder(motion.world, claim));
  const Pendulum pendulum(swinging.omega, swinging.start);
  return JudgeHeld(motion, swinging.held, std::numeric_limits<double>::infinity(),
                   [&](std::size_t s) {
                     return std::vector<PointState>{
                         At(swinging, pendulum.At(motion.trajectory.times[s]))};
                   });
}

Eigen::Vector3d Place(const World& world, const Claim& claim, double t) {
  const Swinging swinging = SwingingOf(world, PointMassesInOrder(world, claim));
  return At(swinging, Pendulum(swinging.omega, swinging.start).At(t)).p_W;
}

constexpr std::array<std::string_view, 1> kNumbers = {"expected_period"};

}  // namespace

constinit const Law kPendulum = {
    .name = "pendulum",
    .documentation = "A mass on one rod to a fixed point swings in a plane.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .smooth = true,
    .place = Place,
};

}  // namespace touchstone
