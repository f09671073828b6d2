#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/simd/lanes.h"

namespace cookbook {

/** The bodies as a solver sees them, all indexed by body. The spans of velocities have
 one more element at the end, the velocity 0 of a null body: it fills lanes without a
 pair. */
struct SolverBodies {
  std::span<const RigidBody> rigid_bodies;      ///< At the start of the step.
  std::span<const InverseInertia> inertias;     ///< At the start of the step.
  std::span<const Velocity> velocities_before;  ///< At the start of the step.
  std::span<Velocity> velocities;               ///< In: without impulses; out: solved.
  std::span<const char> is_static{};            ///< 1 for a static body.
  bool fit_single_precision = false;            ///< See FitsSinglePrecision().
};

/** The change of a Velocity by impulses, in single precision. Its rounding error is a
 fraction of the change, however fast the bodies move together. */
struct alignas(32) SingleVelocity {
  std::array<float, 8> numbers{};  ///< v, ω and two unused. [m/s], [rad/s]
};

/** The velocity that iterations in this precision change. */
template <class Real>
using SolverVelocity =
    std::conditional_t<std::is_same_v<Real, float>, SingleVelocity, Velocity>;

/** The effect of the contacts on a body in a step. */
struct ContactFlags {
  bool bounced = false;  ///< A contact with an impulse bounced.
  bool rested = false;   ///< A contact with an impulse did not bounce.
  bool steady = true;    ///< All contacts with an impulse were steady.
};

/** A contact constraint of each pair of a batch, as the iterations read it. A pair with
 fewer contacts than another has `effective_mass` 0 in its lane, which makes it inert.
 k denotes the response: the change of relative velocity per unit impulse. */
template <class Real>
struct alignas(kAlignment<Real>) ContactConstraintLanes {
  VectorLanes<Real> r_A;          ///< From the centre of A. [m]
  VectorLanes<Real> r_B;          ///< From the centre of B. [m]
  Lanes<Real> impulse;            ///< Accumulated λ, along n. [N s]
  Lanes<Real> friction_impulse1;  ///< Accumulated λ_t, along t1. [N s]
  Lanes<Real> friction_impulse2;  ///< The same along t2. [N s]
  Lanes<Real> target;  ///< Least allowed u·n; −∞ turns the contact off. [m/s]
  Lanes<Real> effective_mass;  ///< 1 / k(n); less if the contact is soft or yields. [kg]
  Lanes<Real> mean_load;       ///< Impulse at which it does not yield. [N s]
  Lanes<Real> impulse_scale;   ///< Softness or yield; 0 if the contact is rigid.
  Lanes<Real> response_n1;     ///< Slip along t1 per unit impulse along n. [1/kg]
  Lanes<Real> response_n2;     ///< Slip along t2 per unit impulse along n. [1/kg]
  Lanes<Real> tangent_mass11;  ///< Inverse of the 2 × 2 response along t1, t2. [kg]
  Lanes<Real> tangent_mass12;
  Lanes<Real> tangent_mass22;
  Lanes<Real> friction_step;  ///< 1 / greatest eigenvalue of that response. [kg]
  // Used in single precision only, where the velocities are changes by impulses and
  // `target` is for those: the slip at the end of the step without impulses. [m/s]
  Lanes<Real> free_slip1;
  Lanes<Real> free_slip2;
};

/** The cold data of the same contact constraints: iterations in single precision do not
 read it. */
template <class Real>
struct alignas(kAlignment<Real>) ContactColdLanes {
  Lanes<Real> separation;       ///< [m]
  Lanes<Real> slop;             ///< Depth that is tolerated. [m]
  Lanes<Real> used;             ///< 1; 0 if the pair has no such contact.
  Lanes<Real> bounces;          ///< 1 if restitution applies.
  Lanes<Real> steady;           ///< 1 if its normal speed before the step was small.
  Lanes<Real> normal_response;  ///< k(n). [1/kg]
  Lanes<Real> slip_response;    ///< 1 / friction_step. [1/kg]
};

/** Pairs that are solved together, one in each lane. No two share a moving body. */
template <class Real>
struct alignas(kAlignment<Real>) ConstraintBatch {
  BodyLanes<Real> pair;  ///< Index of the pair; −1: none.
  BodyLanes<Real> A;
  BodyLanes<Real> B;
  int first;       ///< Index of its first contact constraint; the others follow.
  int count;       ///< Greatest number of contacts of a pair.
  bool is_active;  ///< Whether iterations solve it.
  /** Greatest change of a relative velocity in the last iteration. Unset in single
   precision. [m/s] */
  Lanes<Real> max_change;
  VectorLanes<Real> n;
  VectorLanes<Real> t1;
  VectorLanes<Real> t2;
  Lanes<Real> friction;
  Lanes<Real> inverse_mass_A;
  Lanes<Real> inverse_mass_B;
  TensorLanes<Real> inverse_inertia_A;
  TensorLanes<Real> inverse_inertia_B;
  Lanes<Real> restitution;
  Lanes<Real> load_speed;  ///< h LoadAccelerationOn(): loads add it in a step. [m/s]
  Lanes<Real> slop;        ///< Depth that is tolerated of a rigid contact. [m]
  Lanes<Real> max_sag;     ///< Greatest sag of a contact that yields. [m]
  /** Greatest deviation from the mean load to which contacts yield. 0 if the pair has no
   mean load yet; ∞ with Stabilisation::kSoft. [N s] */
  Lanes<Real> max_deviation;
};

/** Parameters that all contact constraints of a step share. */
struct ContactParameters {
  double h;                             ///< Time step. [s]
  double restitution_threshold_factor;  ///< See Settings.
  double restitution_factor;            ///< 1, or 0 to solve without restitution.
  bool impacts_resolved;                ///< See ContactSolver::Begin().
  double baumgarte;                     ///< Speed per depth beyond the slop, or 0. [1/s]
  double soft_rate;                     ///< Speed per depth beyond the slop, or 0. [1/s]
  double soft_mass_scale;               ///< 1 for hard contacts.
  double soft_impulse_scale;            ///< 0 for hard contacts.
  /** Fraction of the deviation from its mean load that a contact gives up: 0 if it is
   rigid. The damper (1 − yield)/yield m/h, stepped implicitly. */
  double yield;
  /** 1 / (h (2π f)²): the spring of a contact sags by this times k λ̄ under its mean load.
   0 if contacts are rigid. [s] */
  double sag_time;
  double mean_load_fraction;  ///< By which the mean load follows the load.
  bool accumulated;           ///< See Settings::accumulated_impulses.
  bool warm_starting;         ///< Whether to start from the impulses of the pairs.
};

/** Contact constraints and their batches. */
template <class Real>
struct ConstraintView {
  std::span<ConstraintBatch<Real>> batches;
  std::span<ContactConstraintLanes<Real>> contacts;
  std::span<ContactColdLanes<Real>> cold;  ///< Indexed like `contacts`.
};

// All templates below are instantiated for double and float. In single precision an
// impulse has a relative error of about 1e-7. An approach speed has that error relative
// to the changes of velocity and to the contribution of the spins. The two bodies still
// receive opposite impulses at the same point, to the rounding of a double.

/** Fills the contact constraints of the pairs and bodies that the batches name. Reads the
 velocities before the step and those at its end without impulses. The impulses are zero,
 or with `warm_starting` those of the pairs, spread evenly over each face. Returns the
 greatest relative speed at a contact, before the step or at its end without impulses.
 [m/s] */
template <class Real>
double PrepareContacts(const ConstraintView<Real>& constraints,
                       const ContactParameters& parameters,
                       std::span<const ContactPair> pairs, const SolverBodies& bodies);

/** Applies the impulses of the contact constraints. */
template <class Real>
void WarmStartContacts(const ConstraintView<Real>& constraints,
                       std::span<SolverVelocity<Real>> velocities);

/** Applies impulses found in single precision to the velocities of the bodies, in double
 precision. */
void ApplyImpulsesInDouble(const ConstraintView<float>& constraints,
                           const SolverBodies& bodies);

/** Changes of relative velocities in an iteration: the greatest of each pair, and of
 those the greatest and the least. Both are +∞ in single precision, which does not measure
 them. [m/s] */
struct VelocityChanges {
  double max;
  double min;  ///< +∞ if there is no pair.
};

/** One iteration of projected Gauss-Seidel over one colour: solves each contact of the
 active batches once. Two batches at a time are interleaved, which changes no result
 because they share no moving body. Normal impulses are relaxed by the factor
 `relaxation`.
 @pre All batches have one colour. Batches of the last colour come one by one. */
template <class Real>
VelocityChanges SolveContacts(const ConstraintView<Real>& constraints,
                              const ContactParameters& parameters, double relaxation,
                              std::span<SolverVelocity<Real>> velocities);

/** Writes the impulses and mean loads to the pairs, and the flags of the bodies that
 move. */
template <class Real>
void StoreContactImpulses(const ConstraintView<Real>& constraints,
                          const ContactParameters& parameters,
                          std::span<ContactPair> pairs,
                          std::span<ContactFlags> contact_flags);

}  // namespace cookbook
