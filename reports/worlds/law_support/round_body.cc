#include "reports/worlds/law_support/round_body.h"

#include <variant>

namespace touchstone {

double RadiusOf(const RigidBody& round) {
  const Shape& shape = round.placed.shape;
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->radius;
  return std::get<Sphere>(shape).radius;
}

double InertiaRatioOf(const RigidBody& round) {
  const double r = RadiusOf(round);
  return InertiaOf(round).z() / (round.mass * r * r);
}

bool IsEvenSphere(const RigidBody& body) {
  const Eigen::Vector3d inertia = InertiaOf(body);
  return std::holds_alternative<Sphere>(body.placed.shape) &&
         inertia == Eigen::Vector3d::Constant(inertia.x());
}

bool IsEvenRoller(const RigidBody& body) {
  const Eigen::Vector3d inertia = InertiaOf(body);
  return (std::holds_alternative<Capsule>(body.placed.shape) ||
          std::holds_alternative<Cylinder>(body.placed.shape)) &&
         inertia.x() == inertia.y();
}

}  // namespace touchstone
