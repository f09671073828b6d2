#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/truth/rods.h"

namespace touchstone {

/** Points that rods hold: `points[i]` is the i-th of `system`. */
struct HeldByRods {
  std::vector<PointMass> points;
  RodSystem system;

  std::vector<PointState> Start() const;
};

/** Returns why the points are not a chain, the first on a rod to a fixed place and each
 on one to the one before, of the lengths that they start with, under one gravity; empty
 where they are. */
std::string WhyNoChain(const World& world, const std::vector<PointMass>& points);

/** Returns that chain. @pre WhyNoChain() is empty. */
HeldByRods ChainOf(const World& world, const std::vector<PointMass>& points);

/** Holds the points against `truth`, their exact motion at each sample up to `until` [s]:
 position and velocity. The tolerance is 1.5 times the largest error so far of engines of
 first order that keep rods by their velocities, alone, with Baumgarte's term or with
 projected positions (truth/rods.h), stepped beside the truth; and 64 roundings a step. */
std::vector<LawFinding> JudgeHeld(
    const Motion& motion, const HeldByRods& held, double until,
    const std::function<std::vector<PointState>(std::size_t sample)>& truth);

}  // namespace touchstone
