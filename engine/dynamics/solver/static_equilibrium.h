#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/dynamics/solver/elastic_foundation.h"

namespace cookbook {

/** A direct solver for islands that can rest: it finds the contact impulses of a static
 equilibrium without iterations.

 Gauss-Seidel passes a load on from contact to contact. A column of n boxes bends like a
 beam, and takes some n⁴ iterations to come to rest. A heavy body on light ones takes more
 iterations than the ratio of their masses. ElasticFoundation solves the island as a
 whole. The result satisfies the inequalities of ContactSolver with zero velocities, to
 some ten roundings of the impulses on a body.

 A gap that closes with less than a thousandth of the speed that the loads add in a step
 counts as closed: its contact bears load. Later iterations close it, unless it is
 narrower than a millionth. */
class StaticEquilibrium {
 public:
  /** Brings to rest each island of `constraints` that can be, among those in which the
   last iteration changed a relative velocity by more than `solved` [m/s], and which
   iterations have not left faster than loads set a body in motion. Sets its impulses, and
   the velocities of its bodies to 0. Other islands do not change. `islands`, indexed by
   body, is the root of the body's island. `bodies` have their velocities without
   impulses, `velocities` are those of the iterations.

   Islands without a gap to close count as converged: their `max_change` is 0. Further
   iterations would set them in motion, because contacts yield. A heavy body on a light
   one would then fall over, since iterations that do not converge add to the motion.
   Returns whether there is such an island.
   @pre Contacts are hard and impulses accumulate. */
  bool Solve(const ConstraintView<double>& constraints, std::span<const int> islands,
             double solved, const SolverBodies& bodies, std::span<Velocity> velocities);

  /** Sets the impulses and velocities of the islands that count as converged again, since
   iterations change pairs that share a batch with one that has not converged. */
  void Apply(const ConstraintView<double>& constraints,
             std::span<Velocity> velocities) const;

 private:
  /** The position of a pair in the batches. */
  struct Pair {
    int island;  ///< The root of its island.
    std::size_t batch;
    std::size_t lane;
    std::size_t first_impulse;  ///< Index of that of its first contact in impulses_.
    bool is_closed;             ///< Whether no gap of its island has to be closed.
  };

  /** Fills pairs_, sorted by island. */
  void CollectPairs(const ConstraintView<double>& constraints,
                    std::span<const int> islands);
  /** Whether an island has not converged, and is slow enough to be at rest. */
  static bool MayRest(const ConstraintView<double>& constraints,
                      std::span<const Pair> island, double solved,
                      const SolverBodies& bodies, std::span<const Velocity> velocities);
  /** Appends the impulses of an island to impulses_. Returns false if it cannot rest. */
  bool SolveIsland(const ConstraintView<double>& constraints, std::span<Pair> island,
                   const SolverBodies& bodies);
  /** Returns the index of a moving body in foundation_, to which it is added if it is not
   there yet. */
  int IndexOf(int body, const SolverBodies& bodies);

  std::vector<Pair> pairs_;
  std::vector<Eigen::Vector3d> impulses_;  ///< Along n, t1 and t2 of each contact. [N s]
  ElasticFoundation foundation_;
  std::vector<int> indices_;  ///< In foundation_, indexed by body; −1: not there.
};

}  // namespace cookbook
