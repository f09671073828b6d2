#include "reports/referee/core.h"

#include <cmath>
#include <optional>
#include <type_traits>

#include "reports/referee/farthest_vertices.h"

namespace touchstone::referee {
namespace {

struct ToCore {
  const Pose& X_WB;

  RoundedCore operator()(const Sphere& sphere) const {
    return {Point{}, sphere.radius, X_WB};
  }
  RoundedCore operator()(const Capsule& capsule) const {
    return {Segment{capsule.half_length}, capsule.radius, X_WB};
  }
  RoundedCore operator()(const ConvexHull& hull) const {
    return {Vertices(hull.vertices), 0, X_WB};
  }
  // Excluded by the precondition. A point of its boundary keeps the visitor complete.
  RoundedCore operator()(const HalfSpace&) const { return {Point{}, 0, X_WB}; }
  template <typename Solid>
  RoundedCore operator()(const Solid& solid) const {
    return {solid, 0, X_WB};
  }
};

template <typename Real>
struct MaxDot {
  using Number = Bounded<Real>;
  const Vector<Number>& n;

  Number operator()(const Point&) const { return Number(); }
  Number operator()(const Segment& segment) const {
    return Number(segment.half_length) * Abs(n.z);
  }
  Number operator()(const Box& box) const {
    return Number(box.half_extents.x()) * Abs(n.x) +
           Number(box.half_extents.y()) * Abs(n.y) +
           Number(box.half_extents.z()) * Abs(n.z);
  }
  Number operator()(const Vertices& vertices) const {
    std::optional<Number> most;
    const auto visit = [&](const Eigen::Vector3d& v) {
      const Number along = Dot(n, Exactly<Number>(v));
      most = most ? Max(*most, along) : along;
    };
    if constexpr (std::is_same_v<Real, double>) {
      for (const Eigen::Vector3d& v : vertices) visit(v);
    } else {
      ForEachFarthest(vertices,
                      {Nearest(n.x.value()), Nearest(n.y.value()), Nearest(n.z.value())},
                      {n.x.error(), n.y.error(), n.z.error()}, visit);
    }
    return *most;
  }
  Number operator()(const Cylinder& cylinder) const {
    return Number(cylinder.half_length) * Abs(n.z) + Number(cylinder.radius) * Radial();
  }
  Number operator()(const Cone& cone) const {
    const Number apex = Number(cone.half_height) * n.z;
    return Max(apex, Number(cone.radius) * Radial() - apex);
  }
  Number Radial() const { return Sqrt(n.x * n.x + n.y * n.y); }
};

template <typename Real>
struct Farthest {
  const Vector<Real>& n;

  Vector<Real> operator()(const Point&) const { return {Real(0), Real(0), Real(0)}; }
  Vector<Real> operator()(const Segment& segment) const {
    return {Real(0), Real(0), Towards(n.z, segment.half_length)};
  }
  Vector<Real> operator()(const Box& box) const {
    return {Towards(n.x, box.half_extents.x()), Towards(n.y, box.half_extents.y()),
            Towards(n.z, box.half_extents.z())};
  }
  Vector<Real> operator()(const Vertices& vertices) const {
    const Eigen::Vector3d* farthest = &vertices[0];
    std::optional<Real> most;
    const auto visit = [&](const Eigen::Vector3d& v) {
      const Real along = Dot(n, Exactly<Real>(v));
      if (most && !(along > *most)) return;
      most = along;
      farthest = &v;
    };
    if constexpr (std::is_same_v<Real, double>) {
      for (const Eigen::Vector3d& v : vertices) visit(v);
    } else {
      ForEachFarthest(vertices, {Nearest(n.x), Nearest(n.y), Nearest(n.z)},
                      Eigen::Vector3d::Zero(), visit);
    }
    return Exactly<Real>(*farthest);
  }
  Vector<Real> operator()(const Cylinder& cylinder) const {
    return Rim(cylinder.radius, Towards(n.z, cylinder.half_length));
  }
  Vector<Real> operator()(const Cone& cone) const {
    using std::sqrt;
    const Real apex = Real(cone.half_height) * n.z;
    if (apex >= Real(cone.radius) * sqrt(n.x * n.x + n.y * n.y) - apex) {
      return {Real(0), Real(0), Real(cone.half_height)};
    }
    return Rim(cone.radius, Real(-cone.half_height));
  }

  static Real Towards(const Real& along, double half) {
    return along < 0 ? Real(-half) : Real(half);
  }

  /** Returns a point of the disc of `radius` at height `z` that is farthest along n up to
   rounding. The quotient, root and products below err by less than 6 u of the radius, so
   a disc smaller by 8 u keeps the point inside. Squares below 1e-280 could underflow: the
   point is then the centre, 1e-140 short. */
  Vector<Real> Rim(double radius, const Real& z) const {
    using std::sqrt;
    const Real square = n.x * n.x + n.y * n.y;
    if (square < 1e-280) return {Real(0), Real(0), z};
    const Real scale =
        Real(radius) * (Real(1) - Real(8 * kRoundoff<Real>)) / sqrt(square);
    return {n.x * scale, n.y * scale, z};
  }
};

struct Radius {
  double operator()(const Point&) const { return 0; }
  double operator()(const Segment& segment) const { return segment.half_length; }
  double operator()(const Box& box) const { return box.half_extents.norm(); }
  double operator()(const Vertices& vertices) const {
    double most = 0;
    for (const Eigen::Vector3d& v : vertices) most = std::fmax(most, v.squaredNorm());
    return std::sqrt(most);
  }
  double operator()(const Cylinder& c) const {
    return std::hypot(c.radius, c.half_length);
  }
  double operator()(const Cone& c) const { return std::hypot(c.radius, c.half_height); }
};

}  // namespace

RoundedCore CoreOf(const Body& body) {
  return std::visit(ToCore{body.X_WB}, body.shape);
}

bool IsCurved(const Core& core) {
  return std::holds_alternative<Cylinder>(core) || std::holds_alternative<Cone>(core);
}

double CoreRadius(const Core& core) {
  return std::visit(Radius{}, core);
}

template <typename Real>
Bounded<Real> SupportValue(const Core& core, const Vector<Bounded<Real>>& n) {
  return std::visit(MaxDot<Real>{n}, core);
}

template <typename Real>
Vector<Real> SupportPoint(const Core& core, const Vector<Real>& n) {
  return std::visit(Farthest<Real>{n}, core);
}

template Bounded<double> SupportValue(const Core&, const Vector<Bounded<double>>&);
template Bounded<DoubleDouble> SupportValue(const Core&,
                                            const Vector<Bounded<DoubleDouble>>&);
template Bounded<Precise> SupportValue(const Core&, const Vector<Bounded<Precise>>&);
template Vector<double> SupportPoint(const Core&, const Vector<double>&);
template Vector<DoubleDouble> SupportPoint(const Core&, const Vector<DoubleDouble>&);
template Vector<Precise> SupportPoint(const Core&, const Vector<Precise>&);

}  // namespace touchstone::referee
