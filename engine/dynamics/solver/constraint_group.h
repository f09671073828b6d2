#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/dynamics/solver/position_constraint.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** The last of 64 colours of the constraint graph. No two pairs of another colour share a
 moving body. The last colour takes the pairs for which no other colour was free; they
 are solved one after the other. */
inline constexpr int kLastColour = 63;

/** A pair, its colour, and its most used data: pairs are large. */
struct ColouredPair {
  int pair;  ///< Index of the pair.
  int colour;
  int A;
  int B;
  int count;  ///< Number of contacts.
};

/** The contact constraints of some islands, solved together by projected Gauss-Seidel in
 double or single precision. An island is a set of moving bodies connected by contacts. */
template <class Real>
class ConstraintGroup {
 public:
  using Velocities = std::span<SolverVelocity<Real>>;

  /** Prepares the constraints of the pairs `ordered`, which are sorted by colour, and
   warm starts `velocities`. In double precision these are the velocities of the bodies;
   in single precision their changes by impulses, initially zero. */
  void Begin(std::span<const ColouredPair> ordered, std::span<const ContactPair> pairs,
             const SolverBodies& bodies, const ContactParameters& parameters,
             Velocities velocities, ThreadPool& pool);

  /** One iteration over all active contacts, which initially are all contacts. Returns
   the greatest change of a relative velocity, see VelocityChanges. [m/s] `relaxation`:
   see SolveContacts(). */
  double Iterate(double relaxation, Velocities velocities, ThreadPool& pool);

  /** Least change of a relative velocity of a pair in the last iteration. [m/s] */
  double min_change() const { return min_change_; }

  /** Deactivates each island in which the last iteration changed no relative velocity by
   more than `solved` [m/s]. The accuracy of an island then does not depend on the others.
   `islands`, indexed by body, is the root of the body's island; `island_changes` is
   scratch space of one number for each body. */
  void FreezeConvergedIslands(double solved, std::span<const int> islands,
                              std::span<double> island_changes);

  /** Returns all constraints. */
  ConstraintView<Real> view() { return {batches_, contacts_, cold_}; }

  /** Writes the impulses to the pairs, and the flags of the bodies that move. */
  void StoreImpulses(std::span<ContactPair> pairs, std::span<ContactFlags> contact_flags,
                     ThreadPool& pool);

  /** Appends a group of position constraints for the contacts that are too deep.
   `rotates`: whether a correction may rotate bodies, not only translate them. */
  void CollectPositionConstraints(bool rotates, PositionConstraints<Real>& constraints);

  /** Adds the effect of all impulses to the velocities of the bodies, in double
   precision.
   @pre These have no impulses yet: the velocities of the iterations are others. */
  void ApplyToBodies(const SolverBodies& bodies, ThreadPool& pool);

  /** Greatest relative speed at a contact before it is solved. [m/s] */
  double max_speed() const { return max_speed_; }
  /** Number of contacts of the active islands. */
  int constraint_count() const { return constraint_count_; }

 private:
  /** Adds the effect of all impulses to the velocities of the iterations. */
  void ApplyImpulses(Velocities velocities, ThreadPool& pool);
  /** Puts the pairs into batches. `null_body` fills the lanes without a pair. */
  void BuildBatches(std::span<const ColouredPair> ordered, int null_body);
  /** Calls `work(constraints)` for all batches: one colour after the other, each in
   parallel. */
  template <class Work>
  void ForEachColour(ThreadPool& pool, const Work& work);

  std::vector<ConstraintBatch<Real>> batches_;
  std::vector<ContactConstraintLanes<Real>> contacts_;
  std::vector<ContactColdLanes<Real>> cold_;  ///< Indexed like contacts_.
  /** First batch of each colour in use, and the number of batches. */
  std::vector<std::size_t> colour_starts_;
  ContactParameters parameters_{};
  double max_speed_ = 0;
  double min_change_ = 0;  ///< Least change of an active pair, last iteration. [m/s]
  int constraint_count_ = 0;
};

extern template class ConstraintGroup<double>;
extern template class ConstraintGroup<float>;

}  // namespace cookbook
