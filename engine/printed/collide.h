#pragma once

#include <vector>

#include <Eigen/Core>

#include "engine/collision/shape.h"
#include "engine/printed/errata.h"

namespace cookbook::printed {

/** What a published recipe returns: one depth for all contacts, nothing about shapes
 * apart. */
struct Manifold {
  bool touching = false;
  Eigen::Vector3d n_AB_W = Eigen::Vector3d::Zero();  ///< Unit, A to B. Zero where apart.
  double depth = 0;                                  ///< [m]
  std::vector<Eigen::Vector3d> contacts_W;           ///< World frame. [m]
};

/** The published recipe for two spheres, with the given errata. */
Manifold Collide(const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
                 const Errata& errata);

/** The published recipe for a box and a sphere, with the given errata. */
Manifold Collide(const Box& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB,
                 const Errata& errata);

/** As box against sphere, with the roles exchanged. */
Manifold Collide(const Sphere& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                 const Errata& errata);

/** The published recipe for two boxes, with the given errata. */
Manifold Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                 const Errata& errata);

}  // namespace cookbook::printed
