#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracles/trajectory.h"
#include "reports/worlds/law_support/subjects.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** A body or a particle, treated as a point with mass. */
struct PointMass {
  AnchorKind on = AnchorKind::kParticle;
  int index = -1;
  std::string name;
  double mass = 0;
  double damping = 0;  ///< Damping of a particle; 0 for a body. [1/s]
  PointState start;
  Eigen::Vector3d a_W;  ///< Acceleration g + F/m. [m/s²]

  /** Returns its state in `state`. */
  PointState In(const WorldState& state) const;

  /** Returns the function that reads its state, without a spin. */
  std::function<BodyState(const WorldState&)> Reader() const;

  /** Returns whether `anchor` is its centre. */
  bool IsAt(const Anchor& anchor) const;
};

/** Returns the subjects as points, bodies first. */
std::vector<PointMass> PointMassesOf(const World& world, const Subjects& subjects);

/** Returns the subjects as points, in the order in which the claim names them. */
std::vector<PointMass> PointMassesInOrder(const World& world, const Claim& claim);

/** Returns the constant position of `anchor`; empty if it is on something that moves. */
std::optional<Eigen::Vector3d> FixedPointOf(const World& world, const Anchor& anchor);

}  // namespace touchstone
