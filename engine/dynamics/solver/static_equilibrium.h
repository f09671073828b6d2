#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/solver/contact_constraint.h"

namespace cookbook {

/** Finds impulses by which islands come to rest on what does not move.

 Sweeps pass a load on from contact to contact: of a column of n boxes, which bends like a
 beam, they take some n⁴ to bring it to rest. But where each body of a island has one pair
 below it, and one of them stands on something static, what a pair bears is what all that
 is above it needs to stop: known from the momenta alone. Over the contacts of a pair it
 is spread as a stiff even bed would carry it: linearly along the normal, and across it as
 the load is, with the same sum and the same moment.

 Where no contact has to load for that, and none to hold more than its friction, no
 contact moves and none has to: the law of ContactSolver, to some ten roundings of the
 load. A contact that is apart by so little that it arrives with less than a thousandth
 of what gravity adds in a step counts as there: it bears, and the sweeps that follow let
 it come. Where a contact would have to load, the island may still be able to rest, borne
 otherwise: it is left to sweeps, as is a island with a ring, or with two pairs on what is
 static. */
class StaticEquilibrium {
 public:
  /** Brings to rest each island of `rows` that can be, of those in which the last sweep
   changed a relative velocity by more than `solved` [m/s]: changes its impulses, and the
   velocities of its bodies to 0. Of the others nothing changes. Contacts have to be hard.
   `islands` tells of each body which stands for its island. */
  void Find(const ConstraintView<double>& rows, std::span<const int> islands,
            double solved, const SolverBodies& world);

 private:
  /** What a pair or some bodies need. */
  struct Wrench {
    Eigen::Vector3d force;   ///< Impulse. [N s]
    Eigen::Vector3d moment;  ///< About the centre of a body. [N m s]
  };

  /** Where a pair is. */
  struct Place {
    std::size_t batch;
    std::size_t lane;
  };

  /** A body and the pair that it stands on. */
  struct Limb {
    Place place;
    int island;
    std::array<Eigen::Vector3d, 8> impulses;  ///< Along n, t1 and t2, of each contact.
  };

  /** What is known of a island, by the body that stands for it. */
  struct Island {
    int pairs = 0;
    int bodies = 0;
    double change = 0;  ///< The greatest of the last sweep. [m/s]
    bool may_rest = false;
  };

  /** What is known of a body. */
  struct Joint {
    int pairs = 0;         ///< That it is one of, and that are not taken off yet.
    std::size_t last = 0;  ///< The exclusive or of those, and so the last one.
  };

  bool FindTrees(const ConstraintView<double>& rows, std::span<const int> islands,
                 double solved);
  /** Takes bodies that are one of one pair off their island, until none is left. */
  void TakeApart(const ConstraintView<double>& rows, std::span<const int> islands,
                 const SolverBodies& world);

  std::vector<Place> places_;    ///< Of all pairs.
  std::vector<Island> islands_;  ///< By body.
  std::vector<Joint> joints_;    ///< By body.
  std::vector<Wrench> needs_;    ///< By body: of it and of what is taken off it.
  std::vector<int> loose_;       ///< Bodies of one pair.
  std::vector<Limb> limbs_;
};

}  // namespace cookbook
