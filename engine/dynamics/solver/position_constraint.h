#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/simd/lanes.h"

namespace cookbook {

/** A position constraint of each pair of a batch: a contact that is too deep. Lanes with
 `effective_mass` 0 are inert. */
template <class Real>
struct alignas(kAlignment<Real>) PositionConstraintLanes {
  VectorLanes<Real> r_A;       ///< From the centre of A. [m]
  VectorLanes<Real> r_B;       ///< From the centre of B. [m]
  Lanes<Real> depth;           ///< Beyond the slop, at the start of the step. [m]
  Lanes<Real> effective_mass;  ///< 1 / response to a pseudo-impulse along n. [kg]
  Lanes<Real> target;          ///< Displacement along n to be reached. [m]
  Lanes<Real> impulse;         ///< Accumulated pseudo-impulse. [kg m]
};

/** Pairs that are solved together, one in each lane. No two share a moving body. */
template <class Real>
struct alignas(kAlignment<Real>) PositionConstraintBatch {
  BodyLanes<Real> A;
  BodyLanes<Real> B;
  int first;       ///< Index of its first constraint; the others follow.
  int count;       ///< Number of its constraints.
  bool is_active;  ///< Whether any of its constraints has something to correct.
  VectorLanes<Real> n;
  Lanes<Real> load_speed;  ///< See ConstraintBatch. [m/s]
  Lanes<Real> inverse_mass_A;
  Lanes<Real> inverse_mass_B;
  TensorLanes<Real> inverse_inertia_A;
  TensorLanes<Real> inverse_inertia_B;
};

/** Position constraints and their batches, in the order in which they are solved. */
template <class Real>
struct PositionConstraints {
  std::vector<PositionConstraintBatch<Real>> batches;
  std::vector<PositionConstraintLanes<Real>> contacts;
  std::vector<std::size_t> colour_starts;  ///< First batch of each colour of each group.
  std::vector<std::size_t> group_starts;   ///< First batch of each group.

  void Clear() {
    batches.clear();
    contacts.clear();
    colour_starts.clear();
    group_starts.clear();
  }
};

/** Some batches of position constraints. */
template <class Real>
struct PositionConstraintView {
  std::span<PositionConstraintBatch<Real>> batches;
  std::span<PositionConstraintLanes<Real>> contacts;
};

/** The velocities of the bodies in a step, indexed by body. */
struct StepMotion {
  std::span<const Velocity> mean;    ///< Moved the bodies during the step.
  std::span<const Velocity> solved;  ///< At the end of the step.
};

struct PositionParameters {
  double h;         ///< Time step. [s]
  double fraction;  ///< Fraction of the depth beyond the slop to be removed, in (0, 1].
};

// All templates below are instantiated for double and float.

/** Appends a position constraint for each contact that is deeper than its slop and does
 not bounce: one batch for each batch of contacts with such a contact. `rotates`: whether
 the correction may rotate bodies, not only translate them. */
template <class Real>
void CollectDeepContacts(const ConstraintView<Real>& contacts, bool rotates,
                         PositionConstraints<Real>& constraints);

/** Computes the target of each constraint, which is a fraction of the depth that the
 motion of the step has left, and resets the pseudo-impulses. Turns off contacts that
 separate by themselves fast enough. */
template <class Real>
void PreparePositionConstraints(const PositionConstraintView<Real>& constraints,
                                const PositionParameters& parameters,
                                const StepMotion& motion);

/** One iteration of projected Gauss-Seidel over the active batches: adds to
 `corrections`, the displacements [m] and rotations [rad] of the bodies. */
template <class Real>
void SolvePositionConstraints(const PositionConstraintView<Real>& constraints,
                              std::span<SolverVelocity<Real>> corrections);

}  // namespace cookbook
