#include "reports/worlds/truth/jacobi_elliptic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace touchstone {

JacobiElliptic Jacobi(double u, double m, double m1) {
  if (m1 == 0) {
    const double sech = 1 / std::cosh(u);
    return {std::tanh(u), sech, sech};
  }
  // The mean doubles its digits: 16 iterations reach 1 from the smallest double.
  constexpr std::size_t kMost = 16;
  std::array<double, kMost> a{};
  std::array<double, kMost> c{};
  a[0] = 1;
  double b = std::sqrt(m1);
  std::size_t n = 0;
  while (n + 1 < kMost) {
    c[n + 1] = (a[n] - b) / 2;
    a[n + 1] = (a[n] + b) / 2;
    b = std::sqrt(a[n] * b);
    ++n;
    if (c[n] <= std::numeric_limits<double>::epsilon() * a[n]) break;
  }
  // Reduces whole periods 4K first: 2ⁿ aₙ u would lose their digits.
  const double reduced = std::remainder(u, 2 * std::numbers::pi / a[n]);
  double phi = std::ldexp(a[n] * reduced, static_cast<int>(n));
  for (; n > 0; --n) phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2;
  const double cn = std::cos(phi);
  return {std::sin(phi), cn, std::sqrt(m1 + m * cn * cn)};
}

double CompleteEllipticK(double m1) {
  if (m1 == 0) return std::numeric_limits<double>::infinity();
  double a = 1;
  double b = std::sqrt(m1);
  while (std::abs(a - b) > 4 * std::numeric_limits<double>::epsilon() * a) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::numbers::pi / (a + b);
}

double CarlsonRF(double x, double y, double z) {
  double mean = (x + y + z) / 3;
  // The series below omits terms of sixth order: 3e-3 to the sixth is below rounding.
  constexpr double kNear = 2e-3;
  while (std::max({std::abs(x - mean), std::abs(y - mean), std::abs(z - mean)}) >
         kNear * mean) {
    const double lambda = std::sqrt(x) * std::sqrt(y) + std::sqrt(y) * std::sqrt(z) +
                          std::sqrt(z) * std::sqrt(x);
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    mean = (x + y + z) / 3;
  }
  const double X = 1 - x / mean;
  const double Y = 1 - y / mean;
  const double Z = -X - Y;
  const double e2 = X * Y - Z * Z;
  const double e3 = X * Y * Z;
  return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
}

}  // namespace touchstone
