#include "reports/referee/half_space.h"

#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

bool HasHalfSpace(const ContactQuery& query) {
  return KindOf(query.A.shape) == ShapeKind::kHalfSpace ||
         KindOf(query.B.shape) == ShapeKind::kHalfSpace;
}

template <typename Real>
PlaneOverlap OverlapWithPlane(const ContactQuery& query) {
  using Number = Bounded<Real>;
  const bool plane_is_A = KindOf(query.A.shape) == ShapeKind::kHalfSpace;
  const Pose& plane = plane_is_A ? query.A.X_WB : query.B.X_WB;
  const RoundedCore X = CoreOf(plane_is_A ? query.B : query.A);

  const Vector<Number> m = Cross(Exactly<Number>(Eigen::Vector3d(plane.R_WB.col(0))),
                                 Exactly<Number>(Eigen::Vector3d(plane.R_WB.col(1))));
  const Vector<Number> p = Exactly<Number>(plane.p_WB) - Exactly<Number>(X.X_WB.p_WB);
  const Vector<Number> n_X = RotateBack(X.X_WB.R_WB, -m);
  const Number overlap =
      (Dot(m, p) + SupportValue(X.core, n_X)) / Norm(m) + Number(X.radius);

  PlaneOverlap result;
  result.overlap = overlap.enclosure();
  const Eigen::Vector3d m_W = plane.R_WB.col(0).cross(plane.R_WB.col(1)).normalized();
  result.n_AB_W = plane_is_A ? m_W : Eigen::Vector3d(-m_W);
  const Vector<double> q = SupportPoint(
      X.core, RotateBack(X.X_WB.R_WB, Exactly<double>(Eigen::Vector3d(-m_W))));
  result.p_WX = X.X_WB * ToEigen(q) - X.radius * m_W;
  result.p_WPlane = result.p_WX - m_W.dot(result.p_WX - plane.p_WB) * m_W;
  return result;
}

template PlaneOverlap OverlapWithPlane<DoubleDouble>(const ContactQuery&);
template PlaneOverlap OverlapWithPlane<Precise>(const ContactQuery&);

}  // namespace touchstone::referee
