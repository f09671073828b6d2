#pragma once

#include <array>
#include <span>

#include "engine/dynamics/contact_batch.h"

namespace cookbook {

/** One contact of each of four pairs that is too deep, where `mass` is not 0. */
struct alignas(32) OverlapLanes {
  VectorLanes r_A;  ///< From the centre of A. [m]
  VectorLanes r_B;
  Lanes depth;    ///< Beyond the slack, at the start of the step. [m]
  Lanes mass;     ///< What resists a move along n. [kg]
  Lanes excess;   ///< To be removed. [m]
  Lanes impulse;  ///< [kg m]
};

/** Four pairs of which no two share a moving body. */
struct alignas(32) OverlapBatch {
  std::array<int, 4> A;
  std::array<int, 4> B;
  int first;  ///< Its first row; the others follow.
  int count;
  bool at_work;  ///< Whether any contact of it is to be moved.
  VectorLanes n;
  Lanes usual;  ///< As of ContactBatch. [m/s]
  Lanes inverse_mass_A;
  Lanes inverse_mass_B;
  TensorLanes inverse_inertia_A;
  TensorLanes inverse_inertia_B;
};

/** Overlaps and their batches. */
struct OverlapRows {
  std::span<OverlapBatch> batches;
  std::span<OverlapLanes> overlaps;
};

/** How overlap is removed. */
struct OverlapRules {
  double h;      ///< [s]
  double share;  ///< Of the excess, in (0, 1].
};

/** Finds what is to be removed of each overlap, given what has moved the bodies during
 the step and how they move now: contacts that part on their own are let go. */
void FindExcess(const OverlapRows& rows, const OverlapRules& rules,
                std::span<const Velocity> mean, std::span<const Velocity> solved);

/** Removes each overlap once, batch after batch: adds to the moves ([m], [rad]). */
void RemoveExcess(const OverlapRows& rows, std::span<Velocity> moves);

}  // namespace cookbook
