#pragma once

#include <utility>
#include <vector>

#include "engine/dynamics/world/world.h"

namespace cookbook {

/** The constants of one family of springs of a cloth. */
struct ClothSprings {
  double stiffness = 0;  ///< [N/m], >= 0
  double damping = 0;    ///< [N s/m], >= 0
};

/** A cloth: a square mass-spring grid in the x–z plane. Node (row, column) starts at
 centre + ((column − (n−1)/2) x̂ + (row − (n−1)/2) ẑ) spacing. Rest lengths are the
 distances at the start. Structural springs connect neighbours in rows and columns,
 2n(n−1) of them; shear springs connect diagonal neighbours, 2(n−1)²; bend springs connect
 every second node of rows and columns, 2n(n−2). */
struct Cloth {
  int n = 3;                                           ///< Nodes along a side, >= 3.
  double spacing = 1;                                  ///< [m], > 0
  Eigen::Vector3d centre_W = Eigen::Vector3d::Zero();  ///< [m]
  double node_mass = 1;                                ///< [kg], > 0
  double drag = 0;                                     ///< See BodyDefinition.
  double bounce = 0;                                   ///< Restitution, in [0, 1].
  ClothSprings structural;
  ClothSprings shear;
  ClothSprings bend;
  std::vector<std::pair<int, int>> pinned;  ///< (row, column) of nodes that never move.
};

/** Adds the points and springs of `cloth` to `world`. Returns the index of node (0, 0);
 the others follow row by row.
 @throws std::invalid_argument if the cloth is invalid; the world is unchanged then. */
int AddCloth(const Cloth& cloth, World& world);

}  // namespace cookbook
