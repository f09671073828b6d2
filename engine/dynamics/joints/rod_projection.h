#pragma once

#include <span>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "engine/dynamics/joints/axial_constraint.h"
#include "engine/dynamics/joints/distance_joint.h"

namespace cookbook {

/** The projection of velocities onto those that change no length of some rods, in the
 metric of the kinetic energy: v − M⁻¹ Jᵀ (J M⁻¹ Jᵀ)⁻¹ J v, where J v are the rates of the
 lengths. It is the impact of rods without elasticity, solved directly, so that it is
 exact for any masses. It keeps both momenta and never adds energy. It is linear, and
 velocities that it returns are not changed by a second one. */
class RodProjection {
 public:
  /** Sets up the rods `joints` in the poses of `bodies`. */
  void Begin(std::span<const DistanceJoint> joints, std::span<const RigidBody> bodies,
             std::span<const InverseInertia> inertias);

  /** Projects `velocities`, indexed by body. */
  void Project(std::span<Velocity> velocities);

 private:
  std::vector<AxialConstraint> rods_;
  std::span<const InverseInertia> inertias_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;  ///< Of J M⁻¹ Jᵀ.
  Eigen::VectorXd rates_;                                       ///< J v. [m/s]
};

}  // namespace cookbook
