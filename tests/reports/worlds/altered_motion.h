#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "oracles/oracle.h"
#include "oracles/trajectory.h"
#include "scenarios/worlds/world.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {

/** A right motion of a world, with a sample at every step. */
struct RightMotion {
  const World& world;  ///< With a sample at every step.
  const Oracle& oracle;
  const Trajectory& trajectory;
};

/** One kind of error of an engine. */
struct MotionAlteration {
  std::string_view name;
  /** Whether the motion jumps from one step to the next, which no scheme does. */
  bool is_never_legal;
  /** Returns the motion of an engine with this error, of the relative size `size`: of the
   smallest body, of a speed or impulse, of a radian, or of a quantity of the world. Empty
   if the world has nothing that the error is about. */
  std::optional<Trajectory> (*apply)(const RightMotion& right, double size,
                                     RandomScene& random);
};

std::span<const MotionAlteration> MotionAlterations();

/** Returns by how much two motions of a world differ, in the scale of the right one,
 ScaleOf(): the largest difference of a place over the size of the smallest body, of a
 velocity over the top speed, of a spin over both, and of an orientation over 1 rad. If
 only the contacts differ, that of an impulse over the largest, of a point over the size
 and of a normal over 1 rad. [-] */
double DeviationBetween(const World& world, const Trajectory& right,
                        const Trajectory& altered);

}  // namespace touchstone
