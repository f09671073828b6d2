#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/simd/lanes.h"

namespace cookbook {

/** One contact of each of some pairs that is too deep, where `mass` is not 0. */
template <class Real>
struct alignas(kAlignment<Real>) PositionConstraintLanes {
  VectorLanes<Real> r_A;  ///< From the centre of A. [m]
  VectorLanes<Real> r_B;
  Lanes<Real> depth;    ///< Beyond the slop, at the start of the step. [m]
  Lanes<Real> mass;     ///< What resists a move along n. [kg]
  Lanes<Real> excess;   ///< To be removed. [m]
  Lanes<Real> impulse;  ///< [kg m]
};

/** Pairs of which no two share a moving body. */
template <class Real>
struct alignas(kAlignment<Real>) PositionConstraintBatch {
  BodyLanes<Real> A;
  BodyLanes<Real> B;
  int first;  ///< Its first row; the others follow.
  int count;
  bool at_work;  ///< Whether any contact of it is to be moved.
  VectorLanes<Real> n;
  Lanes<Real> usual;  ///< As of ConstraintBatch. [m/s]
  Lanes<Real> inverse_mass_A;
  Lanes<Real> inverse_mass_B;
  TensorLanes<Real> inverse_inertia_A;
  TensorLanes<Real> inverse_inertia_B;
};

/** Overlaps too deep to be left, batch by batch in the order in which they are removed.
 */
template <class Real>
struct Overlaps {
  std::vector<PositionConstraintBatch<Real>> batches;
  std::vector<PositionConstraintLanes<Real>> rows;
  std::vector<std::size_t> firsts;  ///< Batch of each colour, group after group.
  std::vector<std::size_t> groups;  ///< First batch of each group.

  void Clear() {
    batches.clear();
    rows.clear();
    firsts.clear();
    groups.clear();
  }
};

/** Overlaps and their batches. */
template <class Real>
struct PositionConstraintView {
  std::span<PositionConstraintBatch<Real>> batches;
  std::span<PositionConstraintLanes<Real>> overlaps;
};

/** The velocities of the bodies that a position correction takes into account. */
struct StepMotion {
  std::span<const Velocity> mean;    ///< Moved the bodies during the step.
  std::span<const Velocity> solved;  ///< At the end of the step.
};

/** How overlap is removed. */
struct PositionRules {
  double h;      ///< [s]
  double share;  ///< Of the excess, in (0, 1].
};

// All are there for double and for float.

/** Appends what is deeper than its slop, and neither sends back nor is let be: a batch
 for each batch of contacts that has any. `turns`: whether a body may turn, not only move.
 */
template <class Real>
void CollectDeepContacts(const ConstraintView<Real>& rows, bool turns,
                         Overlaps<Real>& overlaps);

/** Finds what is to be removed of each overlap, given what has moved the bodies during
 the step and how they move now: contacts that part on their own are let go. */
template <class Real>
void FindExcess(const PositionConstraintView<Real>& rows, const PositionRules& rules,
                const StepMotion& motion);

/** Removes each overlap once, batch after batch: adds to the moves ([m], [rad]). */
template <class Real>
void RemoveExcess(const PositionConstraintView<Real>& rows,
                  std::span<SolverVelocity<Real>> corrections);

}  // namespace cookbook
