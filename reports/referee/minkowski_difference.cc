#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {
template <typename Real>
Vector<Bounded<Real>> MinkowskiDifference::Centre() const {
  return Exactly<Bounded<Real>>(A_.X_WB.p_WB) - Exactly<Bounded<Real>>(B_.X_WB.p_WB);
}

template <typename Real>
DifferencePoint<Real> MinkowskiDifference::Support(const Vector<Real>& n) const {
  DifferencePoint<Real> point;
  point.q_A = SupportPoint(A_.core, RotateBack(A_.X_WB.R_WB, n));
  point.q_B = SupportPoint(B_.core, RotateBack(B_.X_WB.R_WB, -n));
  point.x = (Exactly<Real>(A_.X_WB.p_WB) - Exactly<Real>(B_.X_WB.p_WB)) +
            (Rotate(A_.X_WB.R_WB, point.q_A) - Rotate(B_.X_WB.R_WB, point.q_B));
  return point;
}

template <typename Real>
Vector<Bounded<Real>> MinkowskiDifference::Place(const Vector<Real>& q_A,
                                                 const Vector<Real>& q_B) const {
  using Number = Bounded<Real>;
  return Centre<Real>() + (Rotate(A_.X_WB.R_WB, Exactly<Number>(q_A)) -
                           Rotate(B_.X_WB.R_WB, Exactly<Number>(q_B)));
}

template <typename Real>
Bounded<Real> MinkowskiDifference::SupportValue(const Vector<Bounded<Real>>& n) const {
  return Dot(n, Centre<Real>()) +
         (referee::SupportValue(A_.core, RotateBack(A_.X_WB.R_WB, n)) +
          referee::SupportValue(B_.core, RotateBack(B_.X_WB.R_WB, -n)));
}

double MinkowskiDifference::Size() const {
  return (A_.X_WB.p_WB - B_.X_WB.p_WB).norm() + CoreRadius(A_.core) + CoreRadius(B_.core);
}

template Vector<Bounded<double>> MinkowskiDifference::Centre() const;
template Vector<Bounded<DoubleDouble>> MinkowskiDifference::Centre() const;
template Vector<Bounded<Precise>> MinkowskiDifference::Centre() const;
template DifferencePoint<double> MinkowskiDifference::Support(
    const Vector<double>&) const;
template DifferencePoint<DoubleDouble> MinkowskiDifference::Support(
    const Vector<DoubleDouble>&) const;
template DifferencePoint<Precise> MinkowskiDifference::Support(
    const Vector<Precise>&) const;
template Vector<Bounded<double>> MinkowskiDifference::Place(const Vector<double>&,
                                                            const Vector<double>&) const;
template Vector<Bounded<DoubleDouble>> MinkowskiDifference::Place(
    const Vector<DoubleDouble>&, const Vector<DoubleDouble>&) const;
template Vector<Bounded<Precise>> MinkowskiDifference::Place(
    const Vector<Precise>&, const Vector<Precise>&) const;
template Bounded<double> MinkowskiDifference::SupportValue(
    const Vector<Bounded<double>>&) const;
template Bounded<DoubleDouble> MinkowskiDifference::SupportValue(
    const Vector<Bounded<DoubleDouble>>&) const;
template Bounded<Precise> MinkowskiDifference::SupportValue(
    const Vector<Bounded<Precise>>&) const;

}  // namespace touchstone::referee
