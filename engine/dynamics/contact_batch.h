#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/dynamics/contact_pair.h"
#include "engine/dynamics/rigid_body.h"

namespace cookbook {

/** Everything about the bodies that a solver sees, by body index. The velocities have one
 more place at the end, zero, for lanes without a pair. */
struct SolverBodies {
  std::span<const RigidBody> bodies;         ///< At the start of the step.
  std::span<const InverseInertia> inertias;  ///< At the start of the step.
  std::span<const Velocity> before;          ///< At the start of the step.
  std::span<Velocity> velocities;            ///< In: without impulses; then solved.
};

/** What contacts did to a body in a step. */
struct Touch {
  bool bounced = false;  ///< Some contact sent it back.
  bool rested = false;   ///< Some contact held it.
  bool steady = true;    ///< Before the step, no contact that held it was approaching.
};

/** One number of each of four pairs. */
using Lanes = std::array<double, 4>;
/** One vector of each of four pairs, component by component. */
using VectorLanes = std::array<Lanes, 3>;
/** One symmetric tensor of each: xx, xy, xz, yy, yz, zz. */
using TensorLanes = std::array<Lanes, 6>;

/** One contact of each of four pairs. A pair that has fewer contacts than another has
 `effective_mass` 0 there, and nothing happens. */
struct alignas(32) ContactLanes {
  // Of the pair.
  VectorLanes r_A;  ///< From the centre of A. [m]
  VectorLanes r_B;
  Lanes separation;         ///< [m]
  Lanes impulse;            ///< λ, along n. [N s]
  Lanes friction_impulse1;  ///< λ_t, along t1. [N s]
  Lanes friction_impulse2;
  Lanes used;  ///< 1, or 0 where the pair has no such contact.
  // Prepared.
  Lanes target;          ///< Least u·n; −∞ where the contact is let be. [m/s]
  Lanes response;        ///< k(n). [1/kg]
  Lanes effective_mass;  ///< 1 / k(n), for a soft contact less. [kg]
  Lanes impulse_scale;   ///< 0 for a hard contact.
  Lanes response_n1;     ///< What a unit impulse along n slips along t1. [1/kg]
  Lanes response_n2;     ///< Along t2.
  Lanes stick11;         ///< Inverse of the response of the slip along t1, t2. [kg]
  Lanes stick12;
  Lanes stick22;
  Lanes slip_response;  ///< Greatest eigenvalue of that response. [1/kg]
  Lanes slip_step;      ///< Its inverse. [kg]
  Lanes bounces;        ///< 1 where it sends back.
  Lanes steady;         ///< 1 where it did not approach before the step.
};

/** Four pairs of which no two share a moving body. */
struct alignas(32) ContactBatch {
  std::array<int, 4> pair;  ///< −1: none.
  std::array<int, 4> A;
  std::array<int, 4> B;
  int first;     ///< Its first contact; the others follow.
  int count;     ///< The greatest number of contacts of a pair.
  bool at_work;  ///< Whether a sweep solves it.
  Lanes change;  ///< The greatest that the last sweep changed a relative velocity. [m/s]
  VectorLanes n;
  VectorLanes t1;
  VectorLanes t2;
  Lanes friction;
  Lanes restitution;
  Lanes usual;  ///< What gravity and forces add in a step, see PullOn(). [m/s]
  Lanes slack;  ///< [m]
  Lanes inverse_mass_A;
  Lanes inverse_mass_B;
  TensorLanes inverse_inertia_A;
  TensorLanes inverse_inertia_B;
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
};

/** Contacts and their batches. */
struct ContactRows {
  std::span<ContactBatch> batches;
  std::span<ContactLanes> contacts;
};

/** Fills the rows of the pairs and bodies that the batches name, given the velocities
 before the step and those at its end without impulses. The impulses are those of the
 pairs, spread evenly over a face, or none without `warm_starting`. Returns the greatest
 relative velocity of a contact. [m/s] */
double PrepareContacts(const ContactRows& rows, const ContactRules& rules,
                       std::span<const ContactPair> pairs, const SolverBodies& world,
                       bool warm_starting);

/** Applies the impulses. */
void ApplyImpulses(const ContactRows& rows, std::span<Velocity> velocities);

/** How much a sweep changed the relative velocities of pairs: of each pair the greatest,
 and of those the greatest and the least. [m/s] */
struct Changes {
  double greatest;
  double least;  ///< +∞ where there is no pair.
};

/** Solves each contact of the batches at work once, batch after batch. What is missing
 along the normal is made up for times `relaxation`. */
Changes SweepContacts(const ContactRows& rows, const ContactRules& rules,
                      double relaxation, std::span<Velocity> velocities);

/** Writes the impulses to the pairs, and what the contacts did to the bodies that move.
 */
void ReadContacts(const ContactRows& rows, std::span<ContactPair> pairs,
                  std::span<Touch> touches);

}  // namespace cookbook
