#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

namespace touchstone {

/** The orientation and the spin of a body. */
struct Rotation {
  Eigen::Quaterniond q_WB;
  Eigen::Vector3d w_WB;  ///< World frame. [rad/s]
};

/** The exact rotation of a free rigid body by Euler's equations I ω̇ = (I ω) × ω.

 The axes are ordered so that a is the one about which the angular momentum L precesses, b
 the middle one and c the last; T is the kinetic energy. Then

   ω_a = ±√((L²−2T I_c)/(I_a(I_a−I_c))) dn u,   u = u₀ + λ t,
   ω_b = ±√((2T I_a−L²)/(I_b(I_a−I_b))) sn u,   λ² = (I_a−I_b)(L²−2T I_c)/(I_a I_b I_c),
   ω_c = ±√((2T I_a−L²)/(I_c(I_a−I_c))) cn u,
   m = (I_b−I_c)(2T I_a−L²)/((I_a−I_b)(L²−2T I_c)).

 Axis a has the largest inertia if L² > 2T I_b, else the least (Landau & Lifshitz,
 Mechanics, §37). The body rotates about L by an angle of rate φ̇ = |L| (I_b ω_b² + I_c
 ω_c²) / (I_b² ω_b² + I_c² ω_c²), which is integrated by Gauss-Legendre quadrature to
 rounding. */
class TorqueFreeRotation {
 public:
  /** @pre `inertia` > 0, principal moments along the body axes [kg m²]. */
  TorqueFreeRotation(const Eigen::Vector3d& inertia, const Rotation& start);

  /** Returns the rotation at each of `times` [s], which are >= 0 and increase. */
  std::vector<Rotation> At(std::span<const double> times) const;

  /** Returns the kinetic energy. [J] */
  double energy() const { return energy_; }

  /** Returns |L|. [N m s] */
  double angular_momentum() const { return L_W_.norm(); }

  /** Returns the period 4K/λ of ω in the body frame; infinite if ω is constant or never
   returns. [s] */
  double period() const;

 private:
  Eigen::Vector3d SpinInBody(double t) const;
  double PrecessionRate(double t) const;
  double Precession(double from, double to) const;

  Eigen::Vector3d inertia_;
  Rotation start_;
  Eigen::Vector3d L_W_;
  double energy_;
  bool steady_;  ///< ω ∥ L: the spin is constant.
  int a_ = 0, b_ = 1, c_ = 2;
  double A_ = 0, B_ = 0, C_ = 0;  ///< Signed amplitudes of dn, sn and cn. [rad/s]
  double lambda_ = 0;             ///< [1/s], >= 0
  double m_ = 0, m1_ = 1;
  double u0_ = 0;
};

}  // namespace touchstone
