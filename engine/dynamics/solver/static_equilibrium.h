#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_constraint.h"

namespace cookbook {

/** A direct solver for islands that can rest on a static body: it finds the contact
 impulses of a static equilibrium without iterations.

 Gauss-Seidel passes a load on from contact to contact. A column of n boxes bends like a
 beam, and takes some n⁴ iterations to come to rest. Here the island has to be a tree:
 each body has one supporting pair below it, and one body stands on a static body. The
 impulse and moment of a supporting pair then follow from momentum alone: they stop all
 that the pair supports. They are distributed over the contacts of the pair as by a rigid
 body on a uniform elastic foundation: linearly in position along the normal, and in
 proportion to that load across it, with the same sum and the same moment.

 The result is accepted if no contact would have to pull and none exceeds its friction.
 It then satisfies the inequalities of ContactSolver with zero velocities, to some ten
 roundings of the load. A gap that closes with less than a thousandth of the speed that
 the loads add in a step counts as closed: its contact bears load, and later iterations
 close it. Where a contact would have to pull, another load distribution may still be in
 equilibrium. Such islands are left to the iterations, and so are those that contain a
 cycle of pairs or stand on static bodies with two pairs. */
class StaticEquilibrium {
 public:
  /** Brings to rest each island of `constraints` that can be, among those in which the
   last iteration changed a relative velocity by more than `solved` [m/s]: sets its
   impulses, and the velocities of its bodies to 0. Other islands do not change.
   `islands`, indexed by body, is the root of the body's island. `bodies` have their
   velocities without impulses, `velocities` are those of the iterations.
   @pre Contacts are hard and impulses accumulate. */
  void Solve(const ConstraintView<double>& constraints, std::span<const int> islands,
             double solved, const SolverBodies& bodies, std::span<Velocity> velocities);

 private:
  /** An impulse and its moment. */
  struct SpatialImpulse {
    Eigen::Vector3d linear;   ///< [N s]
    Eigen::Vector3d angular;  ///< About the centre of a body. [N m s]
  };

  /** The position of a pair in the batches. */
  struct PairPosition {
    std::size_t batch;
    std::size_t lane;
  };

  /** The solution for a pair that supports a body. */
  struct SupportingPair {
    PairPosition position;
    int island;
    std::array<Eigen::Vector3d, 8> impulses;  ///< Along n, t1 and t2 of each contact.
  };

  struct Island {
    int pairs = 0;   ///< Number of pairs.
    int bodies = 0;  ///< Number of bodies that are not removed yet.
    /** Greatest change of a relative velocity in the last iteration. [m/s] */
    double max_change = 0;
    bool may_rest = false;
  };

  /** A body as a node of the contact graph, whose edges are the pairs. */
  struct Node {
    int degree = 0;             ///< Number of its edges that are not removed yet.
    std::size_t edges_xor = 0;  ///< XOR of their indices; with degree 1 the last edge.
  };

  /** Fills nodes and islands. Returns whether any island may be a tree on a static body.
   */
  bool FindTrees(const ConstraintView<double>& constraints, std::span<const int> islands,
                 double solved);
  /** Removes leaves, that is, bodies of degree 1, until none is left, and solves the
   supporting pair of each. */
  void RemoveLeaves(const ConstraintView<double>& constraints,
                    std::span<const int> islands, const SolverBodies& bodies);

  std::vector<PairPosition> edges_;  ///< All pairs.
  std::vector<Island> islands_;      ///< Indexed by the root of the island.
  std::vector<Node> nodes_;          ///< Indexed by body.
  /** Impulse that stops a body and all bodies that it supports. Indexed by body. */
  std::vector<SpatialImpulse> required_;
  std::vector<int> leaves_;  ///< Bodies of degree 1, to be removed.
  std::vector<SupportingPair> supports_;
};

}  // namespace cookbook
