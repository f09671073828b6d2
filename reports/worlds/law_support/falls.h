#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/truth/vertical_bounces.h"

namespace touchstone {

/** A body or particle that falls along the normal of a static plane and bounces on it. */
struct Fall {
  PointMass point;
  Eigen::Vector3d n_W;  ///< Outward unit normal of the plane.
  Height start;
  double gravity;             ///< Acceleration towards the plane, > 0. [m/s²]
  double restitution;         ///< Coefficient e. [-]
  Eigen::Vector3d v_along_W;  ///< Velocity along the plane; constant. [m/s]
  double size;                ///< Bounding radius. [m]

  VerticalBounces Truth() const { return {start, gravity, restitution}; }

  /** Returns the position of its centre after `t` [s]. [m] */
  Eigen::Vector3d PlaceAt(double t) const {
    return point.start.p_W + t * v_along_W + (Truth().At(t).gap - start.gap) * n_W;
  }
};

/** Judges falls by the closed form of their bounces.

 Position: the error of an engine that detects contacts once per step is computed. The
 fall is stepped by the rule that reflects the velocity at the start of the step, with
 contacts detected either when touching or one step ahead. It starts from eight gaps that
 are a fraction of V h apart, since the phase of an impact within its step is random. The
 tolerance is the largest error so far, × 1.5, and 64 roundings per step. An impact is at
 most one step late, which adds V h at the speed V.

 Velocity: before the first impact the body is in free flight, and every scheme has v₀ + g
 t to rounding. The position is a less sharp test of g and of the time: it is behind by
 half a step's fall.

 Restitution: v'/v along the normal, from the speeds [m/s] before and after an impact.
 These are not sampled. The flights through the samples around the impact are followed,
 under g, to the time at which they intersect. Exact flights yield e to rounding, and so
 does an impact that is late or early. An engine may take v₀ + g h for the velocity of the
 whole step, and omit g in the step of the impact or add it before. Either speed is then
 off by up to g h: (1 + e) g h/V. Depth correction raises the second flight by up to V h.
 That moves the intersection by h/(1 + e) and either speed by g times that: g h/V more. A
 body at rest at the second sample and at the next has left with speed 0, since no flight
 leads to where it lies. If a rebound lasts no longer than the sample spacing and a step,
 2 e V/g < Δt + h, the next impact may precede the second sample. Then v' and v are those
 of the samples; gravity may have changed each by g (Δt + h), which replaces g h above. 64
 roundings per step between the samples are added, of either speed and, over V/g, of the
 position. Bounces whose tolerance exceeds ¼ are too slow to judge.

 A motion may be recognised as "reflects the velocity after gravity". Every bounce must
 obey v' = −e (v − g h), to rounding and for a whole number of steps, and the positions
 must be those of falls stepped by that rule. The rule adds m g h V per bounce. It is not
 recognised if e g h is within rounding, so that no bounce distinguishes the rules. Errors
 before the first impact or across the normal are not excused. */
std::vector<LawFinding> JudgeFalls(const Motion& motion, const std::vector<Fall>& falls);

/** Returns whether `v` is along `n`, to the rounding of quaternions with 16 digits. */
bool IsAlong(const Eigen::Vector3d& v, const Eigen::Vector3d& n);

/** Names of the numbers that the laws of bounces derive. */
inline constexpr std::array<std::string_view, 4> kNumbersOfFalls = {
    "expected_first_apex", "expected_first_impact", "expected_impact_speed",
    "expected_total_time"};

/** Returns these numbers for `fall`, as FaultsOfNumbers() takes them. */
std::vector<std::pair<std::string_view, double>> NumbersOf(const Fall& fall);

}  // namespace touchstone
