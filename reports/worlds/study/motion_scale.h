#pragma once

#include <span>

#include "oracles/trajectory.h"
#include "reports/finding/finding.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** The sizes by which the errors of a motion are divided.

 The length L is the greatest extent of the smallest body that moves: twice its bounding
 radius. A world without moving bodies has particles and nodes, which are points: L is
 then the diagonal of the box that contains all of them at all times.

 The speed V is the greatest |v| + |ω| r of the motion, r the bounding radius, but at
 least √(a L), with a the greatest |g + F/m|: the speed that its load gives to a body over
 its own size. A body at rest under gravity is thus graded by what it could fall. And at
 least a speed that takes it 1e-6 L in all: nobody could see a slower motion.

 Everything else follows for a single body of the whole moving mass M at that speed:
 energy ½ M V², momentum M V, angular momentum M V L, force M V² / L, time L / V, spin V /
 L. */
struct MotionScale {
  double length = 0;  ///< L. [m]
  double speed = 0;   ///< V. [m/s]
  double mass = 0;    ///< M. [kg]
};

/** Returns the scale of a motion of `world` by its states, in the order of time. A body
 of mass m that explodes makes V large: the shares of energy and momentum are then about
 m/M. */
MotionScale ScaleOf(const World& world, std::span<const WorldState> states);

/** Returns whether the values of a measure have a size: not whether the oracle answers,
 whether it repeats itself, and the order of convergence. */
bool HasSize(MeasureKind measure);

/** Returns what the values of a measure are divided by, by its unit: 1 for angles [rad]
 and dimensionless numbers. [unit of the measure] */
double SizeFor(MeasureKind measure, const MotionScale& scale);

/** Returns the value of a finding of a motion as a share of SizeFor() its measure. 0 for
 0; infinite for a positive value whose size is 0. [-] */
double ShareOf(const Finding& finding, const MotionScale& scale);

/** Returns the grade of a fault of a motion, by its share. A body that passes through
 another is a wrong hit or miss. A measure without a size is kLarge at most. */
Grade GradeOf(const Finding& finding, const MotionScale& scale);

/** Sets the grade of every fault on that motion. */
void GradeFaults(const MotionScale& scale, std::span<Finding> findings);

}  // namespace touchstone
