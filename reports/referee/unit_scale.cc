#include "reports/referee/unit_scale.h"

#include <cmath>
#include <limits>

namespace touchstone::referee {
namespace {

Body Scaled(const Body& body, int exponent) {
  Body scaled = body;
  scaled.shape = Resized(body.shape, std::ldexp(1, exponent));
  scaled.X_WB.p_WB = InMetres(body.X_WB.p_WB, exponent);
  return scaled;
}

}  // namespace

UnitScale InOwnUnit(const ContactQuery& query) {
  const double size = (query.A.X_WB.p_WB - query.B.X_WB.p_WB).cwiseAbs().maxCoeff() +
                      BoundingRadius(query.A.shape) + BoundingRadius(query.B.shape);
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  return {{Scaled(query.A, -exponent), Scaled(query.B, -exponent)}, exponent};
}

Enclosure InMetres(const Enclosure& length, int exponent) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // The product is exact unless it underflows.
  const auto scaled = [&](double bound, double outwards) {
    const double product = std::ldexp(bound, exponent);
    return std::ldexp(product, -exponent) == bound ? product
                                                   : std::nextafter(product, outwards);
  };
  return {scaled(length.lo, -kInfinity), scaled(length.hi, kInfinity)};
}

Eigen::Vector3d InMetres(const Eigen::Vector3d& length, int exponent) {
  return {std::ldexp(length.x(), exponent), std::ldexp(length.y(), exponent),
          std::ldexp(length.z(), exponent)};
}

}  // namespace touchstone::referee
