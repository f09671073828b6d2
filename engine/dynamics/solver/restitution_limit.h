#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/solver/constraint_group.h"
#include "engine/dynamics/solver/contact_constraint.h"

namespace cookbook {

/** Returns the least fraction s in [0, 1] of a solution without restitution at which the
 energy that an impact adds, elastic + s (inelastic − elastic − curvature) + s² curvature,
 is not positive; 1 if there is none. The energies are in joules.
 @pre elastic > 0. */
double FractionWithoutGain(double elastic, double inelastic, double curvature);

/** A limit on restitution, so that impacts add no energy.

 Newton's restitution with Coulomb friction may add energy if an impact is eccentric (Kane
 & Levinson, Dynamics: Theory and Applications, 1985). The limit takes two solutions for
 an island: J_e with restitution, and J_0 with e = 0. It uses (1 − s) J_e + s J_0 with the
 least s at which no energy is added. These impulses are within the friction cones, which
 are convex. At s = 1 no energy is added, because impulses without restitution do no
 positive work at the velocities after the impact.

 If the iterations end before they have found J_0, their impulses may add energy. The
 limit then uses the greatest multiple of them that adds none. The bodies still approach
 a little.

 Impulses J change the energy by ½ Σ J·(u₀ + u₁), where u₀ and u₁ are the relative
 velocities at a contact before and after the step. Loads do work on a contact that
 resists them: ½ |J·(u_f − u₀)| is allowed, where u_f is the relative velocity with the
 loads and without impulses. */
class RestitutionLimit {
 public:
  /** Returns whether the impulses of `pairs` add energy to an island. If so, keeps this
   solution for Blend(). `solved`: the pairs that have been solved. `free`: velocities
   with the loads and without impulses; `island_roots`: indexed by body. */
  bool Exceeds(std::span<const ContactPair> pairs, std::span<const ColouredPair> solved,
               const SolverBodies& bodies, std::span<const Velocity> free,
               std::span<const int> island_roots);

  /** Replaces the solution of `pairs` and `bodies`, J_0, by the mean or the multiple
   above; J_e is the solution that was kept. */
  void Blend(std::span<ContactPair> pairs, std::span<const ColouredPair> solved,
             const SolverBodies& bodies, std::span<const int> island_roots);

 private:
  /** The energy that the impulses add to an island, see FractionWithoutGain(). [J] */
  struct Island {
    double elastic = 0;
    double inelastic = 0;
    double inelastic_work = 0;  ///< ½ Σ J_0·(u₁ − u_f), the part that is square in J_0.
    double curvature = 0;
    double rounding = 0;  ///< Error of `elastic`.

    /** Returns the least s in [0, 1] that adds no energy. */
    double Fraction() const;

    /** Returns the greatest factor in [0, 1] on the blended impulses that adds none. */
    double Scale() const;
  };

  std::vector<Island> islands_;       ///< Indexed by the root of the island.
  std::vector<ContactPair> elastic_;  ///< The pairs with restitution.
  std::vector<Velocity> elastic_velocities_;
  std::vector<Velocity> free_;
};

}  // namespace cookbook
