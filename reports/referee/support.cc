#include "reports/referee/support.h"

#include <limits>
#include <optional>
#include <variant>

#include "reports/referee/farthest_vertices.h"

namespace touchstone::referee {
namespace {

/** Returns n · x for exact doubles. */
template <typename Real>
Bounded<Real> Along(const Eigen::Vector3d& n, const Eigen::Vector3d& x) {
  return Bounded<Real>(Real(n.x())) * Bounded<Real>(Real(x.x())) +
         Bounded<Real>(Real(n.y())) * Bounded<Real>(Real(x.y())) +
         Bounded<Real>(Real(n.z())) * Bounded<Real>(Real(x.z()));
}

/** The same in double-double, where the products have no error but underflow, and each
 sum has one below 64 u² of itself (double_double.h). */
template <>
Bounded<DoubleDouble> Along(const Eigen::Vector3d& n, const Eigen::Vector3d& x) {
  const DoubleDouble first =
      DoubleDouble::TwoProduct(n.x(), x.x()) + DoubleDouble::TwoProduct(n.y(), x.y());
  const DoubleDouble sum = first + DoubleDouble::TwoProduct(n.z(), x.z());
  const double error = kRoundoff<DoubleDouble> * (Magnitude(first) + Magnitude(sum)) +
                       5 * kUnderflow<DoubleDouble>;
  return Bounded<DoubleDouble>(sum, error);
}

/** The reach of a shape from its centre along the world direction n. */
template <typename Real>
struct Reach {
  using Number = Bounded<Real>;

  const Eigen::Matrix3d& R_WB;
  const Eigen::Vector3d& n_W;

  Number operator()(const Sphere& sphere) const {
    if (sphere.radius == 0) return Number();  // The point of SignedDistance().
    return Number(sphere.radius) * Length();
  }
  Number operator()(const Box& box) const {
    Number reach;
    for (int i = 0; i < 3; ++i) reach = reach + Number(box.half_extents[i]) * Abs(To(i));
    return reach;
  }
  Number operator()(const Capsule& capsule) const {
    return Number(capsule.half_length) * Abs(To(2)) + Number(capsule.radius) * Length();
  }
  Number operator()(const Cylinder& cylinder) const {
    return Number(cylinder.half_length) * Abs(To(2)) + Number(cylinder.radius) * Off();
  }
  // The larger of the apex and the farthest point of the base.
  Number operator()(const Cone& cone) const {
    return Max(Number(cone.half_height) * To(2),
               Number(cone.radius) * Off() - Number(cone.half_height) * To(2));
  }
  Number operator()(const ConvexHull& hull) const {
    const Vector<Number> n = {To(0), To(1), To(2)};
    std::optional<Number> reach;
    ForEachFarthest(
        hull.vertices, {Nearest(n.x.value()), Nearest(n.y.value()), Nearest(n.z.value())},
        {n.x.error(), n.y.error(), n.z.error()}, [&](const Eigen::Vector3d& v) {
          const Number along = Dot(n, Exactly<Number>(v));
          reach = reach ? Max(*reach, along) : along;
        });
    return *reach;
  }
  Number operator()(const HalfSpace&) const {
    return Number(std::numeric_limits<double>::infinity());
  }

  /** The component of n along the image of the body's axis i. */
  Number To(int i) const { return Along<Real>(n_W, R_WB.col(i)); }
  /** The component of n across the body's z axis, in body coordinates. */
  Number Off() const { return Sqrt(To(0) * To(0) + To(1) * To(1)); }
  Number Length() const { return Sqrt(Along<Real>(n_W, n_W)); }
};

}  // namespace

template <typename Real>
Bounded<Real> SupportOf(const Body& body, const Eigen::Vector3d& n_W) {
  return Along<Real>(n_W, body.X_WB.p_WB) +
         std::visit(Reach<Real>{body.X_WB.R_WB, n_W}, body.shape);
}

template Bounded<double> SupportOf(const Body&, const Eigen::Vector3d&);
template Bounded<DoubleDouble> SupportOf(const Body&, const Eigen::Vector3d&);
template Bounded<Precise> SupportOf(const Body&, const Eigen::Vector3d&);

}  // namespace touchstone::referee
