#include "reports/referee/input_rounding.h"

#include <limits>

namespace touchstone::referee {
namespace {

/** Returns the distance from the origin of `body` to its farthest relevant point. For a
 half-space that is the projection of any point of the other body. [m] */
double Reach(const Body& body, const Body& other) {
  if (KindOf(body.shape) != ShapeKind::kHalfSpace) return BoundingRadius(body.shape);
  return (other.X_WB.p_WB - body.X_WB.p_WB).norm() + BoundingRadius(other.shape);
}

/** Returns a bound on the Hausdorff distance by which the rounding of the input moves
 `body`. The signed separation is 1-Lipschitz in that distance: so is the distance of the
 shapes, and so is the overlap along each unit n and hence the least of them. A point R q
 + p of the shape, |q| <= ρ, moves by no more than the sum of
  - ε |p|: one ulp (at most ε |x|) of each coordinate of p,
  - √3 ε ρ: one ulp of each entry of R, since the Frobenius norm of a rotation is √3,
  - ε ρ: one ulp of the sizes,
  - 2 δ ρ: R = Q S with the nearest rotation Q.
 The eigenvalues s of S obey |s − 1| = |s² − 1| / (s + 1), and |s² − 1| <= |RᵀR − 1|₂ <= 3
 δ for the largest entry δ. Hence |S − 1|₂ <= 2 δ as long as s >= 1/2. [m] */
double Displacement(const Body& body, const Body& other) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  const double reach = Reach(body, other);
  return kUlp * (body.X_WB.p_WB.norm() + 3 * reach) +
         2 * OrthonormalityDefect(body.X_WB.R_WB) * reach;
}

}  // namespace

double InputRounding(const ContactQuery& query) {
  return Displacement(query.A, query.B) + Displacement(query.B, query.A);
}

}  // namespace touchstone::referee
