#include "scenarios/transformations.h"

#include <algorithm>
#include <cmath>

#include "scenarios/cube_rotations.h"

namespace touchstone {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;

/** Returns the distance from the world's origin that the query reaches: the maximum of
 |p_WB| + bounding radius. [m] */
double Reach(const ContactQuery& query) {
  return std::max(query.A.X_WB.p_WB.norm() + BoundingRadius(query.A.shape),
                  query.B.X_WB.p_WB.norm() + BoundingRadius(query.B.shape));
}

Body Moved(const Body& body, const Pose& X_MW) {
  return {body.shape,
          Pose::FromMatrix(X_MW * body.X_WB.p_WB, X_MW.R_WB * body.X_WB.R_WB)};
}

Body ScaledBody(const Body& body, double factor) {
  Body scaled{Resized(body.shape, factor), body.X_WB};
  scaled.X_WB.p_WB *= factor;
  return scaled;
}

}  // namespace

TransformedQuery Swapped(const ContactQuery& query) {
  return {{query.B, query.A}, 0};
}

TransformedQuery MovedRigidly(const ContactQuery& query, const Pose& X_MW) {
  // With u the unit roundoff, L the reach and t = p_MW:
  // - An entry of a product of rotations is a sum of three products whose absolute values
  //   sum to at most 1 (Cauchy-Schwarz), so its error is at most 3 u. Together the nine
  //   entries displace a point at distance r by at most 9 u r. For a half-space, r is the
  //   distance of the other shape, at most 2 L.
  // - A coordinate of R p + t is a sum of four terms with an error of 4 u (|p| + |t|).
  // The
  //   error of the position is √3 times that, at most 7 u (L + |t|).
  // - Both bodies together: 2 (18 u L + 7 u (L + |t|)) <= 50 u (L + |t|). The factor 64
  //   covers the second-order terms and the tolerance on R_WB.
  // - R_MW stretches lengths by at most half of |RᵀR − 1| in the 2-norm, which is at most
  //   3 times its largest entry; the longest relevant length is 2 L.
  const double L = Reach(query);
  const double stretch = 3 * OrthonormalityDefect(X_MW.R_WB) * L;
  return {{Moved(query.A, X_MW), Moved(query.B, X_MW)},
          64 * kUnitRoundoff * (L + X_MW.p_WB.norm()) + stretch};
}

TransformedQuery Scaled(const ContactQuery& query, double factor) {
  // Every size and coordinate is rounded once, with a relative error of at most u. So
  // each of the two bodies, with reach L, moves and grows by at most u L.
  int exponent;
  const bool is_power_of_two = std::frexp(factor, &exponent) == 0.5;
  const ContactQuery scaled{ScaledBody(query.A, factor), ScaledBody(query.B, factor)};
  return {scaled, is_power_of_two ? 0 : 2 * kUnitRoundoff * Reach(scaled)};
}

Body Relabelled(const Body& body, int symmetry) {
  const Box* box = std::get_if<Box>(&body.shape);
  if (!box) return body;
  // x_B = S x_B', so x_W = R S x_B' and h = |S| h'. Entries of S are 0 and ±1: sums with
  // zeros and products with ±1 are exact.
  const Eigen::Matrix3d S = CubeRotation(symmetry);
  return {Box{S.transpose().cwiseAbs() * box->half_extents},
          Pose::FromMatrix(body.X_WB.p_WB, body.X_WB.R_WB * S)};
}

TransformedQuery Relabelled(const ContactQuery& query, int symmetry_A, int symmetry_B) {
  return {{Relabelled(query.A, symmetry_A), Relabelled(query.B, symmetry_B)}, 0};
}

TransformedQuery Perturbed(const ContactQuery& query, const Eigen::Vector3d& offset_W) {
  ContactQuery perturbed = query;
  perturbed.B.X_WB.p_WB += offset_W;
  // Each coordinate of the sum is rounded once.
  return {perturbed, kUnitRoundoff * perturbed.B.X_WB.p_WB.norm()};
}

}  // namespace touchstone
