#include "reports/worlds/law_support/sphere.h"

#include <variant>

namespace touchstone {

double RadiusOf(const RigidBody& sphere) {
  return std::get<Sphere>(sphere.placed.shape).radius;
}

double InertiaRatioOf(const RigidBody& sphere) {
  const double r = RadiusOf(sphere);
  return InertiaOf(sphere).x() / (sphere.mass * r * r);
}

bool IsEvenSphere(const RigidBody& body) {
  const Eigen::Vector3d inertia = InertiaOf(body);
  return std::holds_alternative<Sphere>(body.placed.shape) &&
         inertia == Eigen::Vector3d::Constant(inertia.x());
}

}  // namespace touchstone
