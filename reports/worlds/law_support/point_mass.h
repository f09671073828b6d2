#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/law_support/subjects.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** A body or a particle, seen as a point with mass. */
struct PointMass {
  AnchorKind on = AnchorKind::kParticle;
  int index = -1;
  std::string name;
  double mass = 0;
  double damping = 0;  ///< Of a particle. [1/s]
  PointState start;
  Eigen::Vector3d a_W;  ///< g + F/m. [m/s²]

  /** Returns where it is in `state`. */
  PointState In(const WorldState& state) const;

  /** Returns whether `anchor` is its centre. */
  bool IsAt(const Anchor& anchor) const;
};

/** Returns the subjects as points, bodies first. */
std::vector<PointMass> PointMassesOf(const World& world, const Subjects& subjects);

/** Returns the point that `name` bears, in the order that a claim names them. */
std::vector<PointMass> PointMassesInOrder(const World& world, const Claim& claim);

/** Returns where `anchor` is for good; empty where it is on something that moves. */
std::optional<Eigen::Vector3d> FixedPointOf(const World& world, const Anchor& anchor);

}  // namespace touchstone
