#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/solver/contact_constraint.h"

namespace cookbook {

/** Restitution that adds no energy.

 Newton's restitution with Coulomb friction may add energy if an impact is eccentric (Kane
 & Levinson, Dynamics: Theory and Applications, 1985). Then an island has the greatest
 fraction of its restitution that adds none: its impulses are on the line from the
 solution for e to that for 0. They are within the friction cones, which are convex.
 Contacts without restitution add no energy: their impulses do no positive work at the
 velocities after the impact.

 Impulses J change the energy by ½ Σ J·(u₀ + u₁), where u₀ and u₁ are the relative
 velocities at a contact before and after the step. Contacts that resist loads may do work
 up to that of the loads, ½ |J·(u_f − u₀)|, where u_f is the relative velocity with the
 loads and without impulses. Without loads nothing is allowed. */
class RestitutionLimit {
 public:
  /** Finds the islands whose impulses add energy. Returns whether there are any; then
   keeps the solution for Blend(). `free`: velocities with the loads and without impulses;
   `island_roots`: indexed by body. */
  bool Exceeds(std::span<const ContactPair> pairs, const SolverBodies& bodies,
               std::span<const Velocity> free, std::span<const int> island_roots);

  /** Blends the solution without restitution, which `pairs` and `bodies` have now, with
   the solution that was kept. */
  void Blend(std::span<ContactPair> pairs, const SolverBodies& bodies,
             std::span<const int> island_roots);

 private:
  /** The change of energy of an island as a function of the fraction s of the solution
   without restitution: elastic + s (inelastic − elastic − curvature) + s² curvature. [J]
 */
  struct Island {
    double elastic = 0;
    double inelastic = 0;
    double curvature = 0;
    double rounding = 0;  ///< Error of `elastic`.

    /** Returns the least s in [0, 1] that adds no energy. */
    double Fraction() const;
  };

  std::vector<Island> islands_;       ///< Indexed by the root of the island.
  std::vector<ContactPair> elastic_;  ///< The pairs with restitution.
  std::vector<Velocity> elastic_velocities_;
  std::vector<Velocity> free_;
};

}  // namespace cookbook
