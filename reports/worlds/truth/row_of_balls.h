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

/** The rules for impacts in which several pairs touch at once. All conserve momentum and
 all are in use; only experiments can decide between them. */
enum class RowRule {
  kFromFirst,     ///< One pair after another, always the first that approaches.
  kFromLast,      ///< The same, always the last.
  kSimultaneous,  ///< All at once: 0 <= λ ⊥ u' + e u >= 0, Newton's rule as one equation.
};

/** The motion of balls on one line that hit each other, computed from event to event.

 A pair leaves an impact with e times its closing speed. Let N equal balls touch, the
 first of which arrives at v, with e = 1. Sequential impacts yield (0, …, 0, v),
 simultaneous ones (2−N, 2, …, 2) v/N. Both conserve momentum and energy. */
class RowOfBalls {
 public:
  /** `restitution[i]` is that of balls i and i + 1; `touching` [m] is the largest gap of
   balls that touch.

   @pre The balls are in the order of x and overlap by at most `touching`. */
  RowOfBalls(std::vector<RowBall> balls, std::vector<double> restitution, double touching,
             RowRule rule);

  /** Returns the balls after `t` >= 0 [s]. */
  std::vector<RowBall> At(double t) const;

  /** Returns the balls just after their last impact. */
  const std::vector<RowBall>& last() const { return moments_.back().balls; }

  /** Returns the time of the last impact; 0 if there is none. [s] */
  double end() const { return moments_.back().time; }

  /** The accumulated effect of impacts. */
  struct Past {
    int moments;    ///< Number of times at which balls hit each other.
    double change;  ///< Σ |Δv| of all balls. [m/s]
  };

  /** Returns the effect of the impacts up to `t`. */
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
