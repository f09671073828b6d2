#include "reports/worlds/law_support/overlap.h"

#include <algorithm>

#include "reports/referee/referee.h"

namespace touchstone {
namespace {

bool IsHalfSpace(const Body& body) {
  return std::holds_alternative<HalfSpace>(body.shape);
}

/** Whether the bounding spheres of two bodies are apart. */
bool AreFarApart(const Body& A, const Body& B) {
  const Eigen::Vector3d p_AB = B.X_WB.p_WB - A.X_WB.p_WB;
  if (IsHalfSpace(A)) return A.X_WB.R_WB.col(2).dot(p_AB) > BoundingRadius(B.shape);
  if (IsHalfSpace(B)) return -B.X_WB.R_WB.col(2).dot(p_AB) > BoundingRadius(A.shape);
  return p_AB.norm() > BoundingRadius(A.shape) + BoundingRadius(B.shape);
}

}  // namespace

Body PlacedAt(const World& world, const WorldState& state, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  // A static body is exactly where the file put it, to the bit.
  if (body.mass == 0) return body.placed;
  const BodyState& at = state.bodies[static_cast<std::size_t>(index)];
  return {body.placed.shape, Pose::FromQuaternion(at.p_WB, at.q_WB.normalized())};
}

double OverlapOf(const World& world, const WorldState& state, int A, int B) {
  const ContactQuery query{PlacedAt(world, state, A), PlacedAt(world, state, B)};
  if (AreFarApart(query.A, query.B)) return 0;
  const auto* sphere_A = std::get_if<Sphere>(&query.A.shape);
  const auto* sphere_B = std::get_if<Sphere>(&query.B.shape);
  // Piles have thousands of pairs of spheres: their closed form needs no certificate.
  if (sphere_A && sphere_B) {
    return std::max(0.0, sphere_A->radius + sphere_B->radius -
                             (query.B.X_WB.p_WB - query.A.X_WB.p_WB).norm());
  }
  return std::max(0.0, -ComputeContactTruth(query).separation.hi);
}

}  // namespace touchstone
