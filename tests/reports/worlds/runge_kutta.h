#pragma once

#include <Eigen/Core>

namespace touchstone {

/** Integrates ẏ = f(y) over `t` [s] by the classical fourth-order Runge-Kutta method,
 with `steps` and with twice as many steps, extrapolated to fifth order. It is independent
 of every truth that is compared with it. */
template <typename Vector, typename Field>
Vector Integrated(const Field& f, const Vector& start, double t, int steps) {
  const auto run = [&](int n) {
    const double h = t / n;
    Vector y = start;
    for (int i = 0; i < n; ++i) {
      const Vector k1 = f(y);
      const Vector k2 = f(Vector(y + h / 2 * k1));
      const Vector k3 = f(Vector(y + h / 2 * k2));
      const Vector k4 = f(Vector(y + h * k3));
      y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return y;
  };
  const Vector coarse = run(steps);
  const Vector fine = run(2 * steps);
  return fine + (fine - coarse) / 15;
}

}  // namespace touchstone
