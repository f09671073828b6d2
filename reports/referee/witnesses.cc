#include "reports/referee/witnesses.h"

#include <algorithm>
#include <limits>
#include <variant>

#include "reports/referee/bounded.h"

namespace touchstone::referee {
namespace {

template <typename Real>
bool IsAtMost(const Real& a, double b) {
  return a <= b && -a <= b;
}

/** Tells whether a point is certainly in the shape, or in the core of a sphere or a
 capsule. */
template <typename Real>
struct Contains {
  const Vector<Real>& q;

  bool operator()(const Sphere&) const { return q.x == 0 && q.y == 0 && q.z == 0; }
  bool operator()(const Capsule& capsule) const {
    return q.x == 0 && q.y == 0 && IsAtMost(q.z, capsule.half_length);
  }
  bool operator()(const Box& box) const {
    return IsAtMost(q.x, box.half_extents.x()) && IsAtMost(q.y, box.half_extents.y()) &&
           IsAtMost(q.z, box.half_extents.z());
  }
  bool operator()(const Cylinder& cylinder) const {
    return IsAtMost(q.z, cylinder.half_length) && IsInDisc(cylinder.radius);
  }
  // A cone is the convex hull of its apex and its base.
  bool operator()(const Cone& cone) const {
    const bool is_apex = q.x == 0 && q.y == 0 && q.z == cone.half_height;
    return is_apex || (q.z == -cone.half_height && IsInDisc(cone.radius));
  }
  bool operator()(const ConvexHull& hull) const {
    return std::any_of(hull.vertices.begin(), hull.vertices.end(), [&](const auto& v) {
      return q.x == v.x() && q.y == v.y() && q.z == v.z();
    });
  }
  bool operator()(const HalfSpace&) const { return false; }

  bool IsInDisc(double radius) const {
    using Number = Bounded<Real>;
    const Number x(q.x);
    const Number y(q.y);
    const Number r(radius);
    return (x * x + y * y - r * r).enclosure().hi <= 0;
  }
};

struct Radius {
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Capsule& capsule) const { return capsule.radius; }
  template <typename Solid>
  double operator()(const Solid&) const {
    return 0;
  }
};

template <typename Real>
Bounded<Real> Radii(const ContactQuery& query) {
  return Bounded<Real>(std::visit(Radius{}, query.A.shape)) +
         Bounded<Real>(std::visit(Radius{}, query.B.shape));
}

template <typename Real>
Vector<Bounded<Real>> InWorld(const Pose& X_WB, const Vector<Real>& q) {
  using Number = Bounded<Real>;
  // The middle of a sphere, and the point of SignedDistance().
  if (q.x == 0 && q.y == 0 && q.z == 0) return Exactly<Number>(X_WB.p_WB);
  const auto coordinate = [&](int i) {
    return Number(X_WB.R_WB(i, 0)) * Number(q.x) + Number(X_WB.R_WB(i, 1)) * Number(q.y) +
           Number(X_WB.R_WB(i, 2)) * Number(q.z) + Number(X_WB.p_WB[i]);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

}  // namespace

template <typename Real>
double ProvedSeparation(const ContactQuery& query, const Witnesses<Real>& witnesses) {
  using Number = Bounded<Real>;
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  Number total;
  Vector<Number> sum;
  for (std::size_t i = 0; i < static_cast<std::size_t>(witnesses.count); ++i) {
    const Vector<Real>& q_A = witnesses.q_A[i];
    const Vector<Real>& q_B = witnesses.q_B[i];
    if (!std::visit(Contains<Real>{q_A}, query.A.shape) ||
        !std::visit(Contains<Real>{q_B}, query.B.shape) || !(witnesses.weights[i] > 0)) {
      return kNothing;
    }
    const Vector<Number> apart = InWorld(query.B.X_WB, q_B) - InWorld(query.A.X_WB, q_A);
    // The weight of a single pair cancels.
    if (witnesses.count == 1) return (Norm(apart) - Radii<Real>(query)).enclosure().hi;
    const Number weight(witnesses.weights[i]);
    total = total + weight;
    sum = sum + weight * apart;
  }
  const Number distance = Norm(sum) / total;
  return (distance - Radii<Real>(query)).enclosure().hi;
}

template <typename Real>
double LessRadii(const ContactQuery& query, double most) {
  return (Bounded<Real>(most) - Radii<Real>(query)).enclosure().hi;
}

template double ProvedSeparation(const ContactQuery&, const Witnesses<DoubleDouble>&);
template double ProvedSeparation(const ContactQuery&, const Witnesses<Precise>&);
template double LessRadii<DoubleDouble>(const ContactQuery&, double);
template double LessRadii<Precise>(const ContactQuery&, double);

}  // namespace touchstone::referee
