#pragma once

#include "reports/referee/bounded.h"
#include "reports/referee/core.h"
#include "reports/referee/vector.h"

namespace touchstone::referee {

/** A point a − b of the Minkowski difference, with the points a and b. */
template <typename Real>
struct DifferencePoint {
  Vector<Real> q_A;  ///< Point a in the body frame of A. [m]
  Vector<Real> q_B;  ///< Point b in the body frame of B. [m]
  /** a − b in the world frame, to rounding: for searches, not for proofs. [m] */
  Vector<Real> x;
};

/** The Minkowski difference M = {a − b : a in the core of A, b in the core of B}, world
 frame. If the origin is outside M, the distance of the cores is its distance from M. If
 it is in M, the depth of the cores is its distance from the boundary of M. The separation
 of the shapes is that of their cores minus both radii. */
class MinkowskiDifference {
 public:
  /** @pre Both outlive this, and neither is a half-space. */
  MinkowskiDifference(const Body& A, const Body& B) : A_(CoreOf(A)), B_(CoreOf(B)) {}

  const RoundedCore& A() const { return A_; }
  const RoundedCore& B() const { return B_; }
  bool IsCurved() const {
    return referee::IsCurved(A_.core) || referee::IsCurved(B_.core);
  }

  /** Returns p_A − p_B. */
  template <typename Real>
  Vector<Bounded<Real>> Centre() const;

  /** Returns the support point of M along n, up to rounding. */
  template <typename Real>
  DifferencePoint<Real> Support(const Vector<Real>& n) const;

  /** Returns an enclosure of the exact a − b for the points q_A and q_B. */
  template <typename Real>
  Vector<Bounded<Real>> Place(const Vector<Real>& q_A, const Vector<Real>& q_B) const;

  /** Returns the maximum of n · x over M: the overlap of the cores along n, times the
   length of n. */
  template <typename Real>
  Bounded<Real> SupportValue(const Vector<Bounded<Real>>& n) const;

  /** Returns the overlap of the cores along the unit vector that n normalises to. [m] */
  template <typename Real>
  Bounded<Real> OverlapAlong(const Vector<Bounded<Real>>& n) const {
    return SupportValue(n) / Norm(n);
  }

  /** Returns an upper bound on |x| over M, to rounding. Errors of the search are
   multiples of it. [m] */
  double Size() const;

 private:
  RoundedCore A_;
  RoundedCore B_;
};

/** Returns R x for the exact doubles of R. */
template <typename T>
Vector<T> Rotate(const Eigen::Matrix3d& R, const Vector<T>& x) {
  return {T(R(0, 0)) * x.x + T(R(0, 1)) * x.y + T(R(0, 2)) * x.z,
          T(R(1, 0)) * x.x + T(R(1, 1)) * x.y + T(R(1, 2)) * x.z,
          T(R(2, 0)) * x.x + T(R(2, 1)) * x.y + T(R(2, 2)) * x.z};
}

/** Returns Rᵀ x for the exact doubles of R. */
template <typename T>
Vector<T> RotateBack(const Eigen::Matrix3d& R, const Vector<T>& x) {
  return {T(R(0, 0)) * x.x + T(R(1, 0)) * x.y + T(R(2, 0)) * x.z,
          T(R(0, 1)) * x.x + T(R(1, 1)) * x.y + T(R(2, 1)) * x.z,
          T(R(0, 2)) * x.x + T(R(1, 2)) * x.y + T(R(2, 2)) * x.z};
}

}  // namespace touchstone::referee
