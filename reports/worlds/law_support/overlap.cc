#include "reports/worlds/law_support/overlap.h"

#include <algorithm>

#include "reports/referee/referee.h"

namespace touchstone {
namespace {

bool IsHalfSpace(const Body& body) {
  return std::holds_alternative<HalfSpace>(body.shape);
}

}  // namespace

bool AreFarApart(const Body& A, const Body& B, double margin) {
  const Eigen::Vector3d p_AB = B.X_WB.p_WB - A.X_WB.p_WB;
  if (IsHalfSpace(A))
    return A.X_WB.R_WB.col(2).dot(p_AB) > BoundingRadius(B.shape) + margin;
  if (IsHalfSpace(B))
    return -B.X_WB.R_WB.col(2).dot(p_AB) > BoundingRadius(A.shape) + margin;
  return p_AB.norm() > BoundingRadius(A.shape) + BoundingRadius(B.shape) + margin;
}

Body PlacedAt(const World& world, const WorldState& state, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  // A static body is exactly where the file put it, to the bit.
  if (body.mass == 0) return body.placed;
  const BodyState& at = state.bodies[static_cast<std::size_t>(index)];
  return {body.placed.shape, Pose::FromQuaternion(at.p_WB, at.q_WB.normalized())};
}

DeepestOverlap OverlapOf(const World& world, const WorldState& state, int A, int B) {
  const ContactQuery query{PlacedAt(world, state, A), PlacedAt(world, state, B)};
  if (AreFarApart(query.A, query.B, 0)) return {};
  const auto* sphere_A = std::get_if<Sphere>(&query.A.shape);
  const auto* sphere_B = std::get_if<Sphere>(&query.B.shape);
  // Piles have thousands of pairs of spheres: their closed form needs no certificate.
  if (sphere_A && sphere_B) {
    const Eigen::Vector3d p_AB = query.B.X_WB.p_WB - query.A.X_WB.p_WB;
    const double distance = p_AB.norm();
    const double depth = sphere_A->radius + sphere_B->radius - distance;
    if (!(depth > 0)) return {};
    // Concentric spheres part along any direction.
    const Eigen::Vector3d n_W =
        distance > 0 ? Eigen::Vector3d(p_AB / distance) : Eigen::Vector3d::UnitX();
    return {depth, n_W, query.B.X_WB.p_WB - sphere_B->radius * n_W};
  }
  if (AreProvedApart(query)) return {};
  const ContactTruth truth = ComputeContactTruth(query);
  const double depth = -truth.separation.hi;
  if (!(depth > 0)) return {};
  const bool A_is_smaller = !IsHalfSpace(query.A) &&
                            (IsHalfSpace(query.B) || BoundingRadius(query.A.shape) <
                                                         BoundingRadius(query.B.shape));
  return {depth, truth.certificate.n_AB_W,
          A_is_smaller ? truth.certificate.p_WCa : truth.certificate.p_WCb};
}

double DepthOfPoint(const World& world, const WorldState& state, int index,
                    const Eigen::Vector3d& p_W) {
  return std::max(0.0, -SignedDistance(PlacedAt(world, state, index), p_W).hi);
}

Gap GapBetween(const World& world, const WorldState& state, int A, int B) {
  const ContactTruth truth =
      ComputeContactTruth({PlacedAt(world, state, A), PlacedAt(world, state, B)});
  return {std::max(0.0, truth.separation.hi), truth.certificate.n_AB_W,
          truth.certificate.p_WCa, truth.certificate.p_WCb};
}

}  // namespace touchstone
