#include "scenarios/generators/placement.h"

#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/random_shape.h"

namespace touchstone {

Pose RandomPose(Random& random) {
  const double x = random.Uniform(-2, 2);
  const double y = random.Uniform(-2, 2);
  const double z = random.Uniform(-2, 2);
  return Pose::FromQuaternion({x, y, z}, random.Rotation());
}

Body PlacedAgainst(const Body& A, const Feature& on_A, const Shape& shape,
                   const Feature& on_B, double gap, Random& random) {
  const Eigen::Vector3d n_W = Apply(A.X_WB.R_WB, on_A.n_B);
  // A random rotation, then the least rotation that turns the feature towards A; the
  // first determines the spin. Random rotations that leave the feature pointing away from
  // A are rejected, because the least rotation is ill-conditioned there.
  Eigen::Quaterniond q_any;
  Eigen::Vector3d n_any;
  do {
    q_any = random.Rotation();
    n_any = Apply(q_any.toRotationMatrix(), on_B.n_B);
  } while (Dot(n_any, n_W) > 0.9);
  const Eigen::Quaterniond q_WB = Product(LeastRotation(n_any, -n_W), q_any);
  const Eigen::Vector3d p_WCa = A.X_WB.p_WB + Apply(A.X_WB.R_WB, on_A.p_B);
  const Eigen::Vector3d p_BCb_W = Apply(q_WB.toRotationMatrix(), on_B.p_B);
  return {shape, Pose::FromQuaternion(p_WCa + gap * n_W - p_BCb_W, q_WB)};
}

double DistanceAcrossPlane(const Body& A, const Shape& shape, const Pose& X_WB,
                           const Eigen::Vector3d& n_W) {
  const Eigen::Vector3d n_A = ApplyInverse(A.X_WB.R_WB, n_W);
  const Eigen::Vector3d n_B = ApplyInverse(X_WB.R_WB, -n_W);
  return Dot(n_A, SupportPoint(A.shape, n_A)) + Dot(n_B, SupportPoint(shape, n_B));
}

Body PlacedOn(const Body& A, const Feature& on_A, const Shape& shape, const Pose& X_WB,
              double gap) {
  const Eigen::Vector3d n_W = Apply(A.X_WB.R_WB, on_A.n_B);
  const Eigen::Vector3d p_WCa = A.X_WB.p_WB + Apply(A.X_WB.R_WB, on_A.p_B);
  const Eigen::Vector3d p_BCb = SupportPoint(shape, ApplyInverse(X_WB.R_WB, -n_W));
  Body B{shape, X_WB};
  B.X_WB.p_WB = p_WCa + gap * n_W - Apply(X_WB.R_WB, p_BCb);
  return B;
}

Body PlacedAlong(const Body& A, const Shape& shape, const Pose& X_WB,
                 const Eigen::Vector3d& n_W, double gap, double shift, Random& random) {
  const double distance = DistanceAcrossPlane(A, shape, X_WB, n_W) + gap;
  const Eigen::Vector3d any = random.Direction();
  Body B{shape, X_WB};
  B.X_WB.p_WB = A.X_WB.p_WB + distance * n_W + shift * (any - Dot(any, n_W) * n_W);
  return B;
}

Eigen::Vector3d DirectionOr(const Eigen::Vector3d& otherwise, const Body& A,
                            const Shape& shape, const Pose& X_WB) {
  if (KindOf(A.shape) == ShapeKind::kHalfSpace) return A.X_WB.R_WB.col(2);
  if (KindOf(shape) == ShapeKind::kHalfSpace) return -X_WB.R_WB.col(2);
  return otherwise;
}

}  // namespace touchstone
