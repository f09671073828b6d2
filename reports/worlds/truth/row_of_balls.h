#pragma once

#include <vector>

namespace touchstone {

/** A ball on a line. */
struct RowBall {
  double mass;    ///< [kg], > 0
  double radius;  ///< [m]
  double x;       ///< [m]
  double v;       ///< [m/s]
};

/** How impacts in which several pairs touch at once are resolved. All keep momentum, all
 are used; only experiments tell them apart. */
enum class RowRule {
  kFromFirst,     ///< One pair after another, always the first that approaches.
  kFromLast,      ///< The same, always the last.
  kSimultaneous,  ///< All at once: 0 <= λ ⊥ u' + e u >= 0, Newton's rule as one equation.
};

/** Balls on one line that hit each other, from event to event.

 A pair leaves with e times the speed it came with. N equal balls that touch, the first of
 which comes with v, e = 1: one after another (0, …, 0, v); at once (2−N, 2, …, 2) v/N.
 Both keep momentum and energy. */
class RowOfBalls {
 public:
  /** `restitution[i]` is that of balls i and i + 1; `touching` [m] is the gap up to which
   they touch.
   @pre The balls are in the order of x, and do not overlap by more than `touching`. */
  RowOfBalls(std::vector<RowBall> balls, std::vector<double> restitution, double touching,
             RowRule rule);

  /** Returns the balls after `t` >= 0 [s]. */
  std::vector<RowBall> At(double t) const;

  /** Returns the balls after their last impact, where they were then. */
  const std::vector<RowBall>& last() const { return moments_.back().balls; }

  /** Returns when the last impact is; 0 where there is none. [s] */
  double end() const { return moments_.back().time; }

  /** What impacts have done. */
  struct Past {
    int moments;    ///< At how many times balls met.
    double change;  ///< Σ |Δv| of all balls. [m/s]
  };

  /** Returns what happened up to `t`. */
  Past PastAt(double t) const;

  /** The row just after an impact. */
  struct Moment {
    double time;  ///< [s]
    std::vector<RowBall> balls;
    Past past;
  };

  /** Returns the start, then the row after each impact. */
  const std::vector<Moment>& moments() const { return moments_; }

 private:
  const Moment& Before(double t) const;
  bool Resolve(std::vector<RowBall>& balls) const;
  bool ResolveByPairs(std::vector<RowBall>& balls) const;
  bool ResolveAtOnce(std::vector<RowBall>& balls) const;
  bool Touches(const std::vector<RowBall>& balls, std::size_t i) const;

  std::vector<double> restitution_;
  double touching_;
  RowRule rule_;
  std::vector<Moment> moments_;
};

}  // namespace touchstone
