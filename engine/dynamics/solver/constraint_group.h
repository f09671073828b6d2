#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_constraint.h"
#include "engine/dynamics/solver/position_constraint.h"
#include "engine/threads/thread_pool.h"

namespace cookbook {

/** The last of 64 colours that pairs are sorted by, so that no two of a colour share a
 moving body: it is for pairs that found none of the others free, which are solved one
 after the other. */
inline constexpr int kLastColour = 63;

/** A pair, its colour, and what is asked of it most: pairs are large. */
struct ColouredPair {
  int pair;
  int colour;
  int A;
  int B;
  int count;  ///< Of contacts.
};

/** The rows of the pairs of some islands, while they are solved by doubles or by floats.
 A island is what contacts join, without what never moves. */
template <class Real>
class ConstraintGroup {
 public:
  using Velocities = std::span<SolverVelocity<Real>>;

  /** Sets up the rows of `ordered`, which are sorted by colour, and applies the impulses
   to start from to `velocities`, which are those of the world or, in single precision,
   what is changed of them, at first zero. */
  void Begin(std::span<const ColouredPair> ordered, std::span<const ContactPair> pairs,
             const SolverBodies& world, const ContactRules& rules,
             Velocities velocities, ThreadPool& pool);

  /** Sweeps once over all contacts at work, at first all there are, and returns the
   greatest change of a relative velocity, see Changes. [m/s] `relaxation`: see
   SolveContacts(). */
  double Iterate(double relaxation, Velocities velocities, ThreadPool& pool);

  /** Leaves out of the next sweeps the contacts of every island in which the last sweep
   changed no relative velocity by more than `solved` [m/s]: how well one is solved does
   not depend on the others. `islands` tells of each body which stands for its island;
   `island_changes` is room for a number of each body. */
  void FreezeConvergedIslands(double solved, std::span<const int> islands,
                              std::span<double> island_changes);

  /** All rows, while they are solved. */
  ConstraintView<Real> rows() { return {batches_, contacts_, notes_}; }

  /** Writes the impulses to the pairs, and what the contacts did to the bodies. */
  void StoreImpulses(std::span<ContactPair> pairs, std::span<Touch> touches,
                     ThreadPool& pool);

  /** Appends what is too deep; `turns`: whether a body may turn, not only move. */
  void CollectPositionConstraints(bool turns, Overlaps<Real>& overlaps);

  /** Applies what was found in single precision to the velocities of the world; in
   doubles it is there. */
  void Apply(const SolverBodies& world, ThreadPool& pool);

  /** The greatest speed that a contact sees before it is solved. [m/s] */
  double scale() const { return scale_; }
  /** Contacts of the islands that are not solved. */
  int constraint_count() const { return constraint_count_; }

 private:
  void LayOut(std::span<const ColouredPair> ordered, int nobody);
  /** Calls `work(rows)` for all rows: colour after colour, each shared out. */
  template <class Work>
  void ShareByColour(ThreadPool& pool, const Work& work);

  std::vector<ConstraintBatch<Real>> batches_;
  std::vector<ContactLanes<Real>> contacts_;
  std::vector<ContactNotes<Real>> notes_;  ///< Of each of them.
  std::vector<std::size_t> firsts_;        ///< Batch of each colour in use, and the end.
  ContactRules rules_{};
  double scale_ = 0;
  double least_change_ = 0;  ///< Of a pair at work, in the last sweep. [m/s]
  int constraint_count_ = 0;
};

extern template class ConstraintGroup<double>;
extern template class ConstraintGroup<float>;

}  // namespace cookbook
