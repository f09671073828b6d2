#pragma once

namespace touchstone {

/** A height above first contact and its rate. */
struct Height {
  double gap;       ///< [m]
  double velocity;  ///< Upwards. [m/s]
};

/** A body that falls straight down onto a static one and leaves each impact with e times
 its speed V.

 V₀ = √(v₀² + 2 g h₀) after t₀ = (v₀ + V₀)/g. Then flights of 2 V₀ eⁿ/g follow, with apex
 e²ⁿ V₀²/2g. For e < 1 the last one ends at t₀ + 2 V₀ e/(g (1 − e)), and the body
 rests. */
class VerticalBounces {
 public:
  /** @pre gap >= 0, gravity > 0, 0 <= restitution <= 1. */
  VerticalBounces(const Height& start, double gravity, double restitution);

  /** Returns the height after `t`. @pre t >= 0 [s] */
  Height At(double t) const;

  /** Returns V₀. [m/s] */
  double impact_speed() const { return impact_speed_; }

  /** Returns t₀. [s] */
  double first_impact() const { return first_impact_; }

  /** Returns the time at which it comes to rest; infinite for e = 1. [s] */
  double total_time() const;

 private:
  Height start_;
  double gravity_;
  double restitution_;
  double impact_speed_;
  double first_impact_;
};

/** The rules by which an engine that detects contacts once per step reverses a fall. All
 are legal, and agree in the limit of short steps. */
enum class BounceRule {
  /** v' = max(v − g h, −e v): reflects the velocity at the start of the step. */
  kStartOfStep,
  kAfterGravity,  ///< v' = −e (v − g h): reflects the velocity after gravity has acted.
};

/** The step in which an engine detects the contact. */
enum class ContactSeen {
  kTouching,  ///< In the step that starts with gap <= 0.
  kAhead,     ///< In the step that would end with gap < 0.
};

/** A fall stepped by one of the rules: v first, then x += h v. */
struct SteppedBounces {
  BounceRule rule;
  ContactSeen seen;
  double gravity;
  double restitution;
  double dt;
  Height state;

  /** Advances by one step. */
  void Step();
};

}  // namespace touchstone
