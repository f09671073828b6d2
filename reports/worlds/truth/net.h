#pragma once

#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** The decay of the modes ẍ = −ω² x − 2 γ ẋ of a damped system. */
struct Decay {
  double half_damping = 0;           ///< γ. [1/s]
  std::vector<double> frequencies2;  ///< ω² of each mode, ascending. [1/s²]

  /** Returns the rate at which the slowest mode decays: γ, or γ − √(γ² − ω²) if that is
   slower. [1/s] */
  double Slowest() const;

  /** Returns the largest fraction of (x, ẋ/ω) that remains after `t` [s], over the modes
   and over all starts of that size: e^(−γ t + asinh(γ S)), S = sinh(μ t)/μ with μ² = γ² −
   ω², or the largest so far of |sin(ν t)|/ν with ν² = ω² − γ². It is the greatest
   singular value of the solution e^(−γ t) (C + S B), B² = μ², which has determinant
   e^(−2γ t). Damping that acts in phase with the motion can leave more than e^(−γ t) for
   a while. [-] */
  double LeftAfter(double t) const;
};

/** Points under gravity joined by springs: U = Σ ½ k (|p_b − p_a| − L)² − Σ m g·p. */
struct Net {
  /** A spring between two points. */
  struct Link {
    int a = 0;
    int b = 0;
    double stiffness = 0;    ///< [N/m]
    double rest_length = 0;  ///< [m]
    double damping = 0;      ///< [N s/m]; unused by the energy.
  };

  std::vector<double> mass;  ///< [kg]; 0: fixed.
  std::vector<Link> links;
  Eigen::Vector3d g_W;  ///< [m/s²]

  using Points = std::vector<Eigen::Vector3d>;

  /** Returns U. [J] */
  double EnergyAt(const Points& points_W) const;

  /** Returns dU/dp of the points that move, three rows each, in their order. [N] */
  Eigen::VectorXd GradientAt(const Points& points_W) const;

  /** Returns the derivative of the gradient. [N/m] */
  Eigen::MatrixXd HessianAt(const Points& points_W) const;

  /** Returns the nearest minimum of U downhill from `points_W`, to rounding. Newton's
   method with as much of Levenberg's damping as makes U decrease (Nocedal & Wright,
   Numerical Optimization, 2nd ed., §10.3). */
  Points Minimum(Points points_W) const;

  /** Returns the decay of small motions about the minimum `points_W` if velocities decay
   at `damping` [1/s]. */
  Decay DecayAbout(const Points& points_W, double damping) const;
};

}  // namespace touchstone
