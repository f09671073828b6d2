#pragma once

namespace touchstone {

/** An angle from hanging straight down and its rate. */
struct PendulumAngle {
  double theta;  ///< [rad]
  double rate;   ///< [rad/s]
};

/** The exact plane pendulum θ̈ = −Ω² sin θ, Ω² = g/L.

 Let m = sin²(½ θ₀) + (½ θ̇₀/Ω)². For m < 1 it swings: sin ½θ = √m sn(Ω t + u₀, m), θ̇ = 2 Ω
 √m cn. For m > 1 it turns over: sin ½θ = sn(√m Ω t + u₀, 1/m), θ̇ = ±2 Ω √m dn (Landau &
 Lifshitz, Mechanics, §11; Whittaker, Analytical Dynamics, §44). */
class Pendulum {
 public:
  /** @pre `omega` = √(g/L) > 0 [rad/s]; not at rest above the pivot. */
  Pendulum(double omega, const PendulumAngle& start);

  /** Returns the angle after `t` [s], in (−π, π]. */
  PendulumAngle At(double t) const;

  /** Returns the time after which the motion repeats: 4K/Ω, or one turn. Infinite if it
   approaches the upright position. [s] */
  double period() const;

 private:
  double omega_;
  double m_;
  double m1_;  ///< 1 − m.
  double u0_ = 0;
  bool swings_;
  double direction_;  ///< Direction in which it turns over, ±1.
};

}  // namespace touchstone
