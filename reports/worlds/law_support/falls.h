#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/truth/vertical_bounces.h"

namespace touchstone {

/** Something that falls along the normal of a static plane and bounces on it. */
struct Fall {
  std::string name;
  Eigen::Vector3d n_W;  ///< The plane's outward normal, unit.
  Height start;
  double gravity;                                   ///< Along the normal, > 0. [m/s²]
  double restitution;                               ///< e.
  Eigen::Vector3d p_W;                              ///< Its centre at the start. [m]
  Eigen::Vector3d v_along_W;                        ///< Along the plane; stays. [m/s]
  double size;                                      ///< Its bounding radius. [m]
  std::function<PointState(const WorldState&)> is;  ///< Its centre in a motion.

  VerticalBounces Truth() const { return {start, gravity, restitution}; }

  /** Returns where its centre is after `t` [s]. [m] */
  Eigen::Vector3d PlaceAt(double t) const {
    return p_W + t * v_along_W + (Truth().At(t).gap - start.gap) * n_W;
  }
};

/** Holds falls against the closed form of their bounces.

 Position: what an engine that sees contacts once a step is off by is computed: the fall
 is stepped by the rule that reflects the velocity at the start of the step, seen touching
 and seen ahead, from eight gaps a fraction of V h apart, since where in its step the
 impact falls is chance; the largest error so far, × 1.5, and 64 roundings a step. An
 impact is at most a step late, which at the speed V is V h more.

 Velocity: before the first impact it flies freely, and every scheme has v₀ + g t to
 rounding. A position half a step's fall behind tells neither g nor the time as sharply.

 Restitution: v'/v along the normal, of the speeds [m/s] with which it comes to a blow and
 leaves it. They are not sampled: the flights through the samples around the blow are
 followed, under g, to the moment at which they meet. Flights that are exact give e to
 rounding, and so does a blow that comes late or early. An engine that takes v₀ + g h for
 the velocity of the whole step, and leaves g out of the step of the blow or puts it in
 before, has either speed off by up to g h: (1 + e) g h/V. One that lifts what sank in
 raises the second flight by up to V h, which moves where they meet by h/(1 + e) and
 either speed by as much g: g h/V more. What lies at the second sample and at the next has
 left with 0: no flight leads to where it lies. Where a rebound lasts no longer than
 samples are apart and a step, 2 e V/g < Δt + h, the ground may have caught it again: then
 v' and v are those of the samples, of which gravity may have changed each by g (Δt + h),
 for h above. Plus 64 roundings a step between the samples, of either speed and, over V/g,
 of the place. Bounces for which that exceeds ¼ are too slow to tell.

 A motion whose every bounce obeys v' = −e (v − g h), to rounding and the step's number
 being whole, and that is where falls stepped by that rule are, is recognised: "reflects
 the velocity after gravity". It adds m g h V a bounce. Not where e g h is rounding, so
 that no bounce tells the rules apart; nor is what comes before the first impact, or
 across the normal, excused. */
std::vector<LawFinding> JudgeFalls(const Motion& motion, const std::vector<Fall>& falls);

/** Returns whether `v` is along `n`, to the rounding of quaternions with 16 digits. */
bool IsAlong(const Eigen::Vector3d& v, const Eigen::Vector3d& n);

/** The numbers that laws of bounces know. */
inline constexpr std::array<std::string_view, 4> kNumbersOfFalls = {
    "expected_first_apex", "expected_first_impact", "expected_impact_speed",
    "expected_total_time"};

/** Returns them of `fall`, as FaultsOfNumbers() takes them. */
std::vector<std::pair<std::string_view, double>> NumbersOf(const Fall& fall);

}  // namespace touchstone
