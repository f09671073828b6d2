#include "reports/worlds/study/motion_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <Eigen/Geometry>

#include "reports/finding/grade.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Returns the diagonal of the box, along the axes, that contains all particles and nodes
 at all times. [m] */
double ExtentOfPoints(std::span<const WorldState> states) {
  Eigen::AlignedBox3d box;
  for (const WorldState& state : states) {
    for (const PointState& point : state.particles) box.extend(point.p_W);
    for (const PointState& point : state.nodes) box.extend(point.p_W);
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

double LengthOf(const World& world, std::span<const WorldState> states) {
  double least = std::numeric_limits<double>::infinity();
  for (const RigidBody& body : world.bodies) {
    if (body.mass > 0) least = std::min(least, 2 * BoundingRadius(body.placed.shape));
  }
  return std::isinf(least) ? ExtentOfPoints(states) : least;
}

double FastestOf(const World& world, const WorldState& state) {
  double fastest = 0;
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    if (world.bodies[i].mass == 0) continue;
    const double radius = BoundingRadius(world.bodies[i].placed.shape);
    fastest = std::max(
        fastest, state.bodies[i].v_WB.norm() + state.bodies[i].w_WB.norm() * radius);
  }
  for (const PointState& point : state.particles)
    fastest = std::max(fastest, point.v_W.norm());
  for (const PointState& point : state.nodes)
    fastest = std::max(fastest, point.v_W.norm());
  return fastest;
}

double LargestLoadOf(const World& world) {
  double largest =
      world.particles.empty() && world.cloths.empty() ? 0 : world.gravity_W.norm();
  for (const RigidBody& body : world.bodies) {
    if (body.mass > 0) largest = std::max(largest, AccelerationOf(world, body).norm());
  }
  return largest;
}

double MovingMassOf(const World& world) {
  double mass = 0;
  for (const RigidBody& body : world.bodies) mass += body.mass;
  for (const Particle& particle : world.particles) mass += particle.mass;
  for (const Cloth& cloth : world.cloths) mass += cloth.node_mass * cloth.n * cloth.n;
  return mass;
}

/** The share of its length by which a body moves unseen. [-] */
constexpr double kUnseen = 1e-6;

}  // namespace

MotionScale ScaleOf(const World& world, std::span<const WorldState> states) {
  MotionScale scale{.length = LengthOf(world, states), .mass = MovingMassOf(world)};
  scale.speed = std::sqrt(LargestLoadOf(world) * scale.length);
  const double duration = world.steps * world.dt;
  if (duration > 0)
    scale.speed = std::max(scale.speed, kUnseen * scale.length / duration);
  for (const WorldState& state : states)
    scale.speed = std::max(scale.speed, FastestOf(world, state));
  return scale;
}

bool HasSize(MeasureKind measure) {
  return measure != MeasureKind::kAnswering && measure != MeasureKind::kDeterminism &&
         measure != MeasureKind::kObservedOrder;
}

double SizeFor(MeasureKind measure, const MotionScale& scale) {
  const auto& [length, speed, mass] = scale;
  const std::string_view unit = UnitOf(measure);
  if (unit == "m") return length;
  if (unit == "m/s") return speed;
  if (unit == "rad/s") return speed / length;
  if (unit == "N s") return mass * speed;
  if (unit == "N m s") return mass * speed * length;
  if (unit == "J") return mass * speed * speed / 2;
  if (unit == "N") return mass * speed * speed / length;
  if (unit == "s") return length / speed;
  return 1;
}

double ShareOf(const Finding& finding, const MotionScale& scale) {
  return finding.value == 0 ? 0 : finding.value / SizeFor(finding.measure, scale);
}

Grade GradeOf(const Finding& finding, const MotionScale& scale) {
  const Grade grade = GradeOfShare(ShareOf(finding, scale));
  if (!HasSize(finding.measure)) return std::min(grade, Grade::kLarge);
  return finding.measure == MeasureKind::kPassage && grade != Grade::kRounding
             ? Grade::kWrongTouch
             : grade;
}

void GradeFaults(const MotionScale& scale, std::span<Finding> findings) {
  for (Finding& finding : findings) {
    if (IsProvedWrong(finding)) finding.grade = GradeOf(finding, scale);
    if (IsUnusable(finding.verdict)) finding.grade = Grade::kUnusable;
  }
}

}  // namespace touchstone
