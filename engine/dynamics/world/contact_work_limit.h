#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/world/linked_islands.h"

namespace cookbook {

/** A limit on the contact impulses of linked islands, so that they add no energy in a
 step. Rods, springs and loads conserve energy whatever impulses the contacts give, see
 JointSolver. So a step changes the energy of an island by the work of its contacts alone,

   W = Σ J·ū,  ū = the mean relative velocity of the two bodies at the contact.

 W is positive if the iterations have not converged, if friction reverses the slip within
 the step, or if a body turns so that its contact does not move as the solver expects.
 The impulses then are multiplied by the greatest factor k in [0, 1] for which W is not
 positive. They stay in the friction cone and keep both momenta. Since ū is nearly linear
 in k, so is W/k, and the secant method finds k. At k = 0 no work is done. */
class ContactWorkLimit {
 public:
  /** The step that the current factors lead to. Spans are indexed by body. */
  struct Step {
    std::span<const RigidBody> bodies;  ///< At the start of the step.
    std::span<const Velocity> before;
    std::span<const Velocity> mean;  ///< Velocities with which the bodies have moved.
    double h;                        ///< Time step. [s]
  };

  /** Begins a step: all factors are 1. */
  void Begin(std::span<const ContactPair> pairs, const LinkedIslands& islands,
             std::size_t bodies);

  /** Judges the work of the impulses times their factors. Changes the factors of the
   islands for which it is positive, and returns whether there are any. */
  bool Exceeds(const Step& step);

  /** Adds the effect of the impulses times their factors to `velocities`. */
  void AddImpulses(std::span<const RigidBody> bodies,
                   std::span<const InverseInertia> inertias,
                   std::span<Velocity> velocities) const;

  /** Multiplies the impulses of `pairs` by their factors. */
  void Scale(std::span<ContactPair> pairs) const;

 private:
  struct Island {
    double factor = 1;
    double work = 0;      ///< With that factor. [J]
    double rounding = 0;  ///< Error of `work`. [J]
    // The last factor that was judged, and its W/k. [-], [J]
    double last_factor = 0;
    double last_slope = 0;
    int judged = 0;  ///< Number of factors that were judged and changed.
  };
  /** A pair of a linked island, by its index. */
  struct LinkedPair {
    std::size_t index;
    std::size_t island;
  };

  /** Chooses the next factor of an island. */
  static void ChangeFactor(Island& island);

  std::span<const ContactPair> pairs_;
  std::vector<LinkedPair> linked_pairs_;
  std::vector<Island> islands_;  ///< Indexed by LinkedIslands::IslandOf().
};

}  // namespace cookbook
