#include "reports/worlds/truth/oscillator.h"

#include <cmath>

namespace touchstone {

Swing Oscillator::After(const Swing& start, double t) const {
  const double d = omega * omega - damping * damping / 4;
  const double root = std::sqrt(std::abs(d));
  const double phase = root * t;
  const double C = d > 0 ? std::cos(phase) : std::cosh(phase);
  // S = sin(ω_d t)/ω_d; at the limit of both, t.
  const double S = phase == 0 ? t : (d > 0 ? std::sin(phase) : std::sinh(phase)) / root;
  const double decay = std::exp(-damping * t / 2);
  return {decay * (start.x * C + (start.v + damping * start.x / 2) * S),
          decay * (start.v * C - (omega * omega * start.x + damping * start.v / 2) * S)};
}

Swing Stepped(SwingScheme scheme, const Oscillator& oscillator, double h, Swing swing) {
  const double k = oscillator.omega * oscillator.omega;
  const double c = oscillator.damping;
  const double kicked = swing.v - h * (k * swing.x + c * swing.v);
  switch (scheme) {
    case SwingScheme::kVelocityFirst:
      return {swing.x + h * kicked, kicked};
    case SwingScheme::kPositionFirst: {
      const double x = swing.x + h * swing.v;
      return {x, swing.v - h * (k * x + c * swing.v)};
    }
    case SwingScheme::kVelocityFirstDamped: {
      const double v = (swing.v - h * k * swing.x) / (1 + h * c);
      return {swing.x + h * v, v};
    }
    case SwingScheme::kImplicit: {
      const double v = (swing.v - h * k * swing.x) / (1 + h * c + h * h * k);
      return {swing.x + h * v, v};
    }
    case SwingScheme::kExplicit:
      return {swing.x + h * swing.v, kicked};
  }
  return swing;
}

}  // namespace touchstone
