#pragma once

#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** Points under gravity that springs join: U = Σ ½ k (|p_b − p_a| − L)² − Σ m g·p. */
struct Net {
  /** A spring between two points. */
  struct Link {
    int a = 0;
    int b = 0;
    double stiffness = 0;    ///< [N/m]
    double rest_length = 0;  ///< [m]
  };

  std::vector<double> mass;  ///< [kg]; 0: fixed.
  std::vector<Link> links;
  Eigen::Vector3d g_W;  ///< [m/s²]

  using Points = std::vector<Eigen::Vector3d>;

  /** Returns U. [J] */
  double EnergyAt(const Points& points_W) const;

  /** Returns dU/dp of the points that move, three rows each, in their order. [N] */
  Eigen::VectorXd GradientAt(const Points& points_W) const;

  /** Returns its derivative. [N/m] */
  Eigen::MatrixXd HessianAt(const Points& points_W) const;

  /** Returns the minimum of U nearest downhill from `points_W`, to rounding: Newton's
   method with as much of Levenberg's damping as makes U fall (Nocedal & Wright, Numerical
   Optimization, 2nd ed., §10.3). */
  Points Minimum(Points points_W) const;

  /** Returns how fast the slowest small motion about the minimum `points_W` dies where
   velocities decay at `damping` c [1/s]: c/2, or c/2 − √(c²/4 − ω²) where that is slower,
   ω² the least eigenvalue of M⁻¹ U''. [1/s] */
  double SlowestDecay(const Points& points_W, double damping) const;
};

}  // namespace touchstone
