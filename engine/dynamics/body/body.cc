#include "engine/dynamics/body/body.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace cookbook {
namespace {

[[noreturn]] void Refuse(const std::string& what, double value,
                         const std::string& expected) {
  std::ostringstream sentence;
  sentence << "The " << what << " of a body is " << value << "; expected " << expected
           << ".";
  throw std::invalid_argument(sentence.str());
}

void ExpectPositive(const char* what, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    Refuse(what, value, "a positive finite number");
  }
}

void ExpectFinite(const char* what, const Eigen::Vector3d& v) {
  for (const double value : v) {
    if (!std::isfinite(value)) Refuse(what, value, "finite numbers");
  }
}

void ValidateShape(const Sphere& sphere, double) {
  ExpectPositive("radius", sphere.radius);
}

void ValidateShape(const Box& box, double) {
  for (const double h : box.half_extents) ExpectPositive("half extent", h);
}

void ValidateShape(const HalfSpace&, double mass) {
  if (mass != 0) Refuse("mass", mass, "0 for a half-space, which cannot move");
}

void ValidateShape(const Point&, double) {}

void ValidateInertia(const Eigen::Vector3d& inertia) {
  // Moments are sums of squared distances over the mass: I1 + I2 >= I3, to rounding.
  constexpr double kRounding = 1e-12;
  for (const double moment : inertia) ExpectPositive("moment of inertia", moment);
  for (int k = 0; k < 3; ++k) {
    if (2 * inertia[k] > inertia.sum() * (1 + kRounding)) {
      Refuse("moment of inertia", inertia[k], "at most the sum of the other two");
    }
  }
}

}  // namespace

Eigen::Vector3d PrincipalInertia(const BodyShape& shape, double mass) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    return Eigen::Vector3d::Constant(0.4 * mass * sphere->radius * sphere->radius);
  }
  // With half extents h the full sizes are 2 h, and m/12 becomes m/3.
  const Eigen::Array3d s = std::get<Box>(shape).half_extents.array().square();
  return mass / 3 * Eigen::Vector3d(s[1] + s[2], s[0] + s[2], s[0] + s[1]);
}

void Validate(const BodyDefinition& body) {
  if (!(body.mass >= 0) || !std::isfinite(body.mass)) {
    Refuse("mass", body.mass, "a finite number >= 0 kg");
  }
  std::visit([&](const auto& shape) { ValidateShape(shape, body.mass); }, body.shape);
  ExpectFinite("position", body.state.p_WB);
  ExpectFinite("velocity", body.state.v_WB);
  ExpectFinite("angular velocity", body.state.w_WB);
  ExpectFinite("force", body.force_W);
  const double norm = body.state.q_WB.norm();
  if (!(std::abs(norm - 1) <= 1e-6)) {
    Refuse("orientation", norm, "a quaternion of length 1");
  }
  if (!(body.restitution >= 0 && body.restitution <= 1)) {
    Refuse("restitution", body.restitution, "a number in [0, 1]");
  }
  if (!(body.friction >= 0) || !std::isfinite(body.friction)) {
    Refuse("friction", body.friction, "a finite number >= 0");
  }
  if (body.inertia && body.mass > 0) ValidateInertia(*body.inertia);
  if (!(body.drag >= 0) || !std::isfinite(body.drag)) {
    Refuse("drag", body.drag, "a finite number >= 0");
  }
  if (body.drag > 0 && !std::holds_alternative<Point>(body.shape)) {
    Refuse("drag", body.drag, "0 for a body that is not a point");
  }
}

}  // namespace cookbook
