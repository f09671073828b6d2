#pragma once

#include <array>

namespace touchstone {

/** A displacement from rest and its rate. */
struct Swing {
  double x;  ///< [m]
  double v;  ///< [m/s]
};

/** A damped harmonic oscillator: ẍ = −ω² x − c ẋ. */
struct Oscillator {
  double omega;    ///< √(k/m). [rad/s], > 0
  double damping;  ///< Damping c. [1/s], >= 0

  /** Returns the motion after `t` [s]: e^{−ct/2} (x₀ C + (v₀ + ½ c x₀) S) with C = cos
   ω_d t, S = sin(ω_d t)/ω_d, ω_d² = ω² − ¼ c²; hyperbolic if that is negative. */
  Swing After(const Swing& start, double t) const;
};

/** A first-order scheme for an oscillator. */
enum class SwingScheme {
  kVelocityFirst,        ///< v += h a(x, v), x += h v: semi-implicit Euler.
  kPositionFirst,        ///< x += h v, v += h a(x, v): its adjoint.
  kVelocityFirstDamped,  ///< v = (v − h ω² x)/(1 + h c), x += h v.
  kImplicit,             ///< v = (v − h ω² x)/(1 + h c + h² ω²), x += h v.
  kExplicit,             ///< Both by the state at the start of the step.
};

/** The schemes that keep the energy bounded if ω h < 2 and nothing is damped. */
inline constexpr std::array kSymplecticSwings = {SwingScheme::kVelocityFirst,
                                                 SwingScheme::kPositionFirst,
                                                 SwingScheme::kVelocityFirstDamped};

/** Returns `swing` one step of `h` [s] later. Undamped and velocity first, n steps are
 x_n = A cos nθ + B sin nθ with cos θ = 1 − ½ h² ω². */
Swing Stepped(SwingScheme scheme, const Oscillator& oscillator, double h, Swing swing);

}  // namespace touchstone
