#pragma once

#include <vector>

#include <Eigen/Core>

#include "engine/collision/shape.h"
#include "engine/printed/errata.h"

namespace cookbook::printed {

/** The contact manifold of a published recipe: one depth for all contacts, and no data if
 the shapes are apart. */
struct Manifold {
  bool touching = false;
  Eigen::Vector3d n_AB_W = Eigen::Vector3d::Zero();  ///< Unit, A to B; zero if apart.
  double depth = 0;                                  ///< [m]
  std::vector<Eigen::Vector3d> contacts_W;           ///< World frame. [m]
};

/** The published recipe for two spheres, with the given errata. */
Manifold Collide(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
                 const Errata& errata);

/** The published recipe for a box and a sphere, with the given errata. */
Manifold Collide(const Box& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
                 const Errata& errata);

/** The published recipe for a sphere and a box: the above with swapped roles. */
Manifold Collide(const Sphere& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                 const Errata& errata);

/** The published recipe for two boxes, with the given errata. */
Manifold Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                 const Errata& errata);

}  // namespace cookbook::printed
