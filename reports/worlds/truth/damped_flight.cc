#include "reports/worlds/truth/damped_flight.h"

#include <cmath>

namespace touchstone {

PointState DampedFlight(const PointState& start, const Eigen::Vector3d& g_W, double c,
                        double t) {
  const double x = c * t;
  // s/t and (t − s)/(c t²) by their series where the closed forms cancel; the truncation
  // error is x⁵/5040 of them.
  const double s = x > 1e-2 ? -std::expm1(-x) / x
                            : 1 - x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5)));
  const double r =
      x > 1e-2 ? (1 - s) / x : (1 - x / 3 * (1 - x / 4 * (1 - x / 5 * (1 - x / 6)))) / 2;
  const Eigen::Vector3d pull_W = g_W - c * start.v_W;
  return {start.p_W + start.v_W * t + pull_W * (r * t * t), start.v_W + pull_W * (s * t)};
}

std::array<FlightScheme, 8> FlightSchemes() {
  std::array<FlightScheme, 8> schemes;
  for (unsigned i = 0; i < schemes.size(); ++i)
    schemes[i] = {(i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
  return schemes;
}

void StepFlight(const FlightScheme& scheme, const Eigen::Vector3d& g_W, double c,
                double h, PointState& state) {
  const double kept = scheme.linear ? 1 - c * h : std::exp(-c * h);
  if (scheme.moves_first) state.p_W += h * state.v_W;
  state.v_W = scheme.damps_first ? Eigen::Vector3d(kept * state.v_W + h * g_W)
                                 : Eigen::Vector3d(kept * (state.v_W + h * g_W));
  if (!scheme.moves_first) state.p_W += h * state.v_W;
}

}  // namespace touchstone
