#pragma once

namespace touchstone {

/** A height above where contact begins, and its rate. */
struct Height {
  double gap;       ///< [m]
  double velocity;  ///< Upwards. [m/s]
};

/** What falls straight down on what never moves, and leaves each time with the share e of
 the speed V it came with.

 V₀ = √(v₀² + 2 g h₀) after t₀ = (v₀ + V₀)/g; then flights of 2 V₀ eⁿ/g with apex e²ⁿ
 V₀²/2g; for e < 1 the last one ends at t₀ + 2 V₀ e/(g (1 − e)), and it rests. */
class VerticalBounces {
 public:
  /** @pre gap >= 0, gravity > 0, 0 <= restitution <= 1. */
  VerticalBounces(const Height& start, double gravity, double restitution);

  /** Returns where it is after `t`. @pre t >= 0 [s] */
  Height At(double t) const;

  /** Returns V₀. [m/s] */
  double impact_speed() const { return impact_speed_; }

  /** Returns t₀. [s] */
  double first_impact() const { return first_impact_; }

  /** Returns when it comes to rest; infinite for e = 1. [s] */
  double total_time() const;

 private:
  Height start_;
  double gravity_;
  double restitution_;
  double impact_speed_;
  double first_impact_;
};

/** How an engine that sees contacts once a step turns a fall. All are legal, and the same
 in the limit of short steps. */
enum class BounceRule {
  kStartOfStep,  ///< v' = max(v − g h, −e v): reflects the velocity the step starts with.
  kAfterGravity,  ///< v' = −e (v − g h): reflects the velocity after gravity has acted.
};

/** When it sees the contact. */
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
