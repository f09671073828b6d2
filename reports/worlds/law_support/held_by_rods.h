#pragma once

#include <string>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/truth/rods.h"

namespace touchstone {

/** Points held by rods: `points[i]` is the i-th point of `system`. */
struct HeldByRods {
  std::vector<PointMass> points;
  RodSystem system;

  std::vector<PointState> Start() const;
};

/** Returns the reason why the points are not a chain; empty if they are. In a chain the
 first point is on a rod to a fixed point and each other one on a rod to its predecessor.
 The rods have their lengths at the start and keep them, and gravity is the only load. */
std::string WhyNoChain(const World& world, const std::vector<PointMass>& points);

/** Returns that chain. @pre WhyNoChain() is empty. */
HeldByRods ChainOf(const World& world, const std::vector<PointMass>& points);

/** Judges position and velocity of the points by `truth`, their exact motion at the first
 samples; the others are not judged. The tolerance is 1.5 times the largest error so far
 of first-order engines, stepped next to the truth, and 64 roundings per step. These
 engines constrain the velocities of rods, alone, with Baumgarte's term or with projected
 positions (truth/rods.h).

 An engine that keeps a length by the mean velocity v̄ of a step has v̄·(d₀ + d₁) = 0, hence
 v₁·d₁ = ¼ h (|v₁|² − |v₀|²) − v₀·d₀ to second order. This velocity along each rod is
 granted, too. It counts where the first-order engines are right by chance, as near free
 fall. */
std::vector<LawFinding> JudgeHeld(const Motion& motion, const HeldByRods& held,
                                  const std::vector<std::vector<PointState>>& truth);

}  // namespace touchstone
