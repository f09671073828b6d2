#include "engine/dynamics/body/rigid_body.h"

#include <algorithm>
#include <limits>

#include "engine/dynamics/body/rotation.h"

namespace cookbook {
namespace {

double BoundingRadius(const BodyShape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  if (const auto* box = std::get_if<Box>(&shape)) return box->half_extents.norm();
  return 0;
}

}  // namespace

RigidBody MakeRigidBody(const BodyDefinition& definition) {
  Validate(definition);
  RigidBody body;
  body.shape = definition.shape;
  body.state = definition.state;
  body.state.q_WB.normalize();
  body.R_WB = body.state.q_WB.toRotationMatrix();
  body.inverse_mass = definition.mass > 0 ? 1 / definition.mass : 0;
  body.moments.setZero();
  body.inverse_moments.setZero();
  if (definition.mass == 0) body.state.v_WB.setZero();
  if (definition.mass == 0 || std::holds_alternative<Point>(body.shape)) {
    body.state.w_WB.setZero();
  } else {
    body.moments = definition.inertia
                       ? *definition.inertia
                       : PrincipalInertia(definition.shape, definition.mass);
    body.inverse_moments = body.moments.cwiseInverse();
  }
  body.is_isotropic = body.moments[0] > 0 && IsIsotropic(body.moments);
  body.restitution = definition.restitution;
  body.friction = definition.friction;
  body.collides = definition.collides;
  body.is_sphere = std::holds_alternative<Sphere>(body.shape);
  body.is_point = std::holds_alternative<Point>(body.shape);
  body.drag = definition.drag;
  body.radius = BoundingRadius(definition.shape);
  body.force_W = definition.force_W;
  body.has_forces = !body.force_W.isZero(0);
  return body;
}

double InnerRadius(const RigidBody& body) {
  if (const auto* box = std::get_if<Box>(&body.shape))
    return box->half_extents.minCoeff();
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) return sphere->radius;
  return std::holds_alternative<HalfSpace>(body.shape)
             ? std::numeric_limits<double>::infinity()
             : 0;
}

double SmallerInnerRadius(const RigidBody& A, const RigidBody& B) {
  return A.is_static()   ? InnerRadius(B)
         : B.is_static() ? InnerRadius(A)
                         : std::min(InnerRadius(A), InnerRadius(B));
}

double SafePenetration(const RigidBody& A, const RigidBody& B) {
  return 0.5 * (InnerRadius(A) + InnerRadius(B));
}

double Travel(const BodyState& before, const RigidBody& body) {
  const double distance = (body.state.p_WB - before.p_WB).norm();
  if (body.is_sphere) return distance;
  // A rotation by θ moves a point at r by 2 r sin(θ/2), and the vector part of
  // q q₀⁻¹ has the length sin(θ/2).
  const double sine = (body.state.q_WB * before.q_WB.conjugate()).vec().norm();
  return distance + 2 * body.radius * sine;
}

InverseInertia InverseInertiaOf(const RigidBody& body) {
  const Eigen::Vector3d& moments = body.inverse_moments;
  // Without this the products with R would make the tensor slightly non-diagonal.
  if (IsIsotropic(moments)) {
    return {{moments[0], 0, 0, moments[0], 0, moments[0]}, body.inverse_mass};
  }
  const Eigen::Matrix3d I_W = body.R_WB * moments.asDiagonal() * body.R_WB.transpose();
  return {{I_W(0, 0), I_W(1, 0), I_W(2, 0), I_W(1, 1), I_W(2, 1), I_W(2, 2)},
          body.inverse_mass};
}

}  // namespace cookbook
