#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/simd/lanes.h"

namespace cookbook {

/** Everything about the bodies that a solver sees, by body index. The velocities have one
 more place at the end, zero, for lanes without a pair. */
struct SolverBodies {
  std::span<const RigidBody> bodies;         ///< At the start of the step.
  std::span<const InverseInertia> inertias;  ///< At the start of the step.
  std::span<const Velocity> before;          ///< At the start of the step.
  std::span<Velocity> velocities;            ///< In: without impulses; then solved.
  std::span<const char> is_static{};         ///< By body: 1 where it is.
  bool fit_single_precision = false;         ///< See FitsSinglePrecision().
};

/** What impulses change of a Velocity, in single precision: its rounding is a share of
 that, however fast the bodies go together. */
struct alignas(32) SingleVelocity {
  std::array<float, 8> numbers{};  ///< v, ω and two of no concern. [m/s], [rad/s]
};

/** What sweeps of this precision change. */
template <class Real>
using SolverVelocity =
    std::conditional_t<std::is_same_v<Real, float>, SingleVelocity, Velocity>;

/** What contacts did to a body in a step. */
struct Touch {
  bool bounced = false;  ///< Some contact sent it back.
  bool rested = false;   ///< Some contact held it.
  bool steady = true;    ///< Before the step, no contact that held it was approaching.
};

/** One contact of each of some pairs, as sweeps see it. A pair that has fewer contacts
 than another has `effective_mass` 0 there, and nothing happens. */
template <class Real>
struct alignas(kAlignment<Real>) ContactLanes {
  VectorLanes<Real> r_A;  ///< From the centre of A. [m]
  VectorLanes<Real> r_B;
  Lanes<Real> impulse;            ///< λ, along n. [N s]
  Lanes<Real> friction_impulse1;  ///< λ_t, along t1. [N s]
  Lanes<Real> friction_impulse2;
  Lanes<Real> target;          ///< Least u·n; −∞ where the contact is let be. [m/s]
  Lanes<Real> effective_mass;  ///< 1 / k(n), for a soft contact less. [kg]
  Lanes<Real> impulse_scale;   ///< 0 for a hard contact.
  Lanes<Real> response_n1;     ///< What a unit impulse along n slips along t1. [1/kg]
  Lanes<Real> response_n2;     ///< Along t2.
  Lanes<Real> stick11;         ///< Inverse of the response of the slip along t1, t2. [kg]
  Lanes<Real> stick12;
  Lanes<Real> stick22;
  Lanes<Real> slip_step;  ///< 1 / the greatest eigenvalue of that response. [kg]
  // In single precision, where sweeps see what impulses change of a velocity, and
  // `target` is of that: the slip at the end of the step without impulses. [m/s]
  Lanes<Real> slip1;
  Lanes<Real> slip2;
};

/** What sweeps in single precision do not look at of the same contacts. */
template <class Real>
struct alignas(kAlignment<Real>) ContactNotes {
  Lanes<Real> separation;     ///< [m]
  Lanes<Real> used;           ///< 1, or 0 where the pair has no such contact.
  Lanes<Real> bounces;        ///< 1 where it sends back.
  Lanes<Real> steady;         ///< 1 where it did not approach before the step.
  Lanes<Real> response;       ///< k(n). [1/kg]
  Lanes<Real> slip_response;  ///< 1 / slip_step. [1/kg]
};

/** Pairs of which no two share a moving body. */
template <class Real>
struct alignas(kAlignment<Real>) ConstraintBatch {
  BodyLanes<Real> pair;  ///< −1: none.
  BodyLanes<Real> A;
  BodyLanes<Real> B;
  int first;           ///< Its first contact; the others follow.
  int count;           ///< The greatest number of contacts of a pair.
  bool at_work;        ///< Whether a sweep solves it.
  Lanes<Real> change;  ///< The greatest that the last sweep changed a relative velocity.
                       ///< Not in single precision. [m/s]
  VectorLanes<Real> n;
  VectorLanes<Real> t1;
  VectorLanes<Real> t2;
  Lanes<Real> friction;
  Lanes<Real> inverse_mass_A;
  Lanes<Real> inverse_mass_B;
  TensorLanes<Real> inverse_inertia_A;
  TensorLanes<Real> inverse_inertia_B;
  Lanes<Real> restitution;
  Lanes<Real> usual;  ///< What gravity and forces add in a step, see LoadAccelerationOn(). [m/s]
  Lanes<Real> slop;   ///< [m]
};

/** What the rows are made by. */
struct ContactRules {
  double h;                ///< [s]
  double resting_speed;    ///< As Settings.
  double baumgarte;        ///< Share of the excess depth, or 0.
  double soft_rate;        ///< Speed per excess depth, or 0. [1/s]
  double soft_mass_scale;  ///< 1 where hard.
  double soft_impulse_scale;
  bool accumulated;
  bool warm_starting;
};

/** Contacts and their batches. */
template <class Real>
struct ConstraintView {
  std::span<ConstraintBatch<Real>> batches;
  std::span<ContactLanes<Real>> contacts;
  std::span<ContactNotes<Real>> notes;  ///< Of each of the contacts.
};

// All of these are there for double and for float. In single precision an impulse is off
// by some 1e-7 of itself, and an approach by as much of what is changed and of what the
// spins make of it; the two bodies receive opposite impulses at the same place all the
// same, to the rounding of a double.

/** Fills the rows of the pairs and bodies that the batches name, given the velocities
 before the step and those at its end without impulses. The impulses are those of the
 pairs, spread evenly over a face, or none without `warm_starting`. Returns the greatest
 relative velocity of a contact. [m/s] */
template <class Real>
double PrepareContacts(const ConstraintView<Real>& rows, const ContactRules& rules,
                       std::span<const ContactPair> pairs, const SolverBodies& world);

/** Applies the impulses. */
template <class Real>
void ApplyImpulses(const ConstraintView<Real>& rows,
                   std::span<SolverVelocity<Real>> velocities);

/** Applies impulses found in single precision to the velocities themselves. */
void ApplyFoundImpulses(const ConstraintView<float>& rows, const SolverBodies& world);

/** How much a sweep changed the relative velocities of pairs: of each pair the greatest,
 and of those the greatest and the least; +∞ in single precision, where it is not known.
 [m/s] */
struct Changes {
  double greatest;
  double least;  ///< +∞ where there is no pair.
};

/** Solves each contact of the batches at work once, batch after batch. What is missing
 along the normal is made up for times `relaxation`. */
template <class Real>
Changes SolveContacts(const ConstraintView<Real>& rows, const ContactRules& rules,
                      double relaxation, std::span<SolverVelocity<Real>> velocities);

/** Writes the impulses to the pairs, and what the contacts did to the bodies that move.
 */
template <class Real>
void ReadContacts(const ConstraintView<Real>& rows, std::span<ContactPair> pairs,
                  std::span<Touch> touches);

}  // namespace cookbook
