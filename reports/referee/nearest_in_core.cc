#include "reports/referee/nearest_in_core.h"

#include <variant>

#include "reports/referee/direction.h"

namespace touchstone::referee {
namespace {

using Real = DoubleDouble;
using V = Vector<Real>;

/** A nearest point of a core as a convex combination of at most two points, and an
 outward normal of the face that the point is farthest beyond. In the frame of the body.
 */
struct NearestOfCore {
  std::array<V, 2> points;
  std::array<Real, 2> weights = {1, 0};
  V normal;  ///< Not normalised; zero if the point is not outside.

  V Point() const {
    const Real total = weights[0] + weights[1];
    return (1 / total) * (weights[0] * points[0] + weights[1] * points[1]);
  }
};

Real Clamped(const Real& x, double most) {
  return x > most ? Real(most) : x < -most ? Real(-most) : x;
}

Real Sign(const Real& x) {
  return x < 0 ? -1 : 1;
}

/** Returns the radius of the largest disc whose rim points, rounded, are certainly inside
 the given one: as in Farthest::Rim() (core.cc). [m] */
Real Inside(double radius) {
  return Real(radius) * (1 - 8 * kRoundoff<Real>);
}

struct NearestTo {
  const V& q;

  NearestOfCore operator()(const Point&) const { return {.points = {}, .normal = q}; }

  NearestOfCore operator()(const Segment& segment) const {
    const Real z = Clamped(q.z, segment.half_length);
    return {.points = {V{0, 0, z}}, .normal = {q.x, q.y, q.z - z}};
  }

  NearestOfCore operator()(const Box& box) const {
    const V nearest = {Clamped(q.x, box.half_extents.x()),
                       Clamped(q.y, box.half_extents.y()),
                       Clamped(q.z, box.half_extents.z())};
    const V beyond = q - nearest;
    NearestOfCore result;
    result.points[0] = nearest;
    if (abs(beyond.x) >= abs(beyond.y) && abs(beyond.x) >= abs(beyond.z)) {
      result.normal.x = beyond.x;
    } else if (abs(beyond.y) >= abs(beyond.z)) {
      result.normal.y = beyond.y;
    } else {
      result.normal.z = beyond.z;
    }
    return result;
  }

  NearestOfCore operator()(const Cylinder& cylinder) const {
    const Real out = Out();
    const Real z = Clamped(q.z, cylinder.half_length);
    const Real beyond_side = out - cylinder.radius;
    const Real beyond_end = abs(q.z) - cylinder.half_length;
    NearestOfCore result;
    result.points[0] = {q.x, q.y, z};
    if (beyond_side > 0) {
      const Real shrunk = Inside(cylinder.radius) / out;
      result.points[0] = {shrunk * q.x, shrunk * q.y, z};
    }
    if (beyond_side > 0 && beyond_side >= beyond_end) {
      result.normal = {q.x, q.y, 0};
    } else if (beyond_end > 0) {
      result.normal.z = Sign(q.z);
    }
    return result;
  }

  NearestOfCore operator()(const Cone& cone) const {
    const double h = cone.half_height;
    const double r = cone.radius;
    const Real out = Out();
    const bool has_side = out > 0;
    const V rim = {has_side ? Inside(r) / out * q.x : Real(0),
                   has_side ? Inside(r) / out * q.y : Real(0), -h};
    // The side falls from (0, h) to (r, −h). The point divides it at t from the apex.
    const Real square = Real(r) * r + Real(4) * h * h;
    const Real t = (out * r + (h - q.z) * 2 * h) / square;
    const Real beyond_side = (out * 2 * h + (q.z - h) * r) / sqrt(square);
    const Real beyond_base = -h - q.z;
    NearestOfCore result;
    if (beyond_base > 0 && beyond_base >= beyond_side) {
      result.normal.z = -1;
    } else if (beyond_side > 0 && has_side) {
      result.normal = {2 * h / out * q.x, 2 * h / out * q.y, r};
    }
    if (beyond_side > 0 && t < 1) {
      result.points = {V{0, 0, h}, rim};
      result.weights = t > 0 ? std::array<Real, 2>{1 - t, t} : std::array<Real, 2>{1, 0};
    } else {
      result.points[0] = out > Inside(r) ? rim : V{q.x, q.y, -h};
    }
    return result;
  }

  NearestOfCore operator()(const Vertices&) const { return {}; }

  Real Out() const { return sqrt(q.x * q.x + q.y * q.y); }
};

/** Returns R⁻ᵀ n for a matrix that is almost a rotation: its columns are the cross
 products of those of R. */
V Normal(const Eigen::Matrix3d& R, const V& n) {
  const V x = Exactly<Real>(Eigen::Vector3d(R.col(0)));
  const V y = Exactly<Real>(Eigen::Vector3d(R.col(1)));
  const V z = Exactly<Real>(Eigen::Vector3d(R.col(2)));
  return n.x * Cross(y, z) + n.y * Cross(z, x) + n.z * Cross(x, y);
}

}  // namespace

std::optional<CoreTruth<DoubleDouble>> NearestInCore(const MinkowskiDifference& M) {
  const Eigen::Matrix3d& R = M.A().X_WB.R_WB;
  // Rᵀ inverts R up to some roundings, and a second step inverts it to their square.
  const V p = Exactly<Real>(M.B().X_WB.p_WB) - Exactly<Real>(M.A().X_WB.p_WB);
  const V first = RotateBack(R, p);
  const V q = first + RotateBack(R, p - Rotate(R, first));
  const NearestOfCore nearest = std::visit(NearestTo{q}, M.A().core);
  if (Dot(nearest.normal, nearest.normal) == 0) return std::nullopt;

  // The difference of both points has the direction to some digits if it is long enough.
  const V apart = p - Rotate(R, nearest.Point());
  const Real size = M.Size();
  const bool is_long = Dot(apart, apart) > 0x1p-60 * (size * size);
  CoreTruth<Real> truth;
  truth.separation = {0, 0};
  truth.n_AB_W = Direction(is_long ? apart : Normal(R, nearest.normal));
  truth.points.count = nearest.weights[1] > 0 ? 2 : 1;
  for (std::size_t i = 0; i < 2; ++i) {
    truth.points.weights[i] = nearest.weights[i];
    truth.points.q_A[i] = nearest.points[i];
    truth.points.q_B[i] = {0, 0, 0};
  }
  return truth;
}

}  // namespace touchstone::referee
