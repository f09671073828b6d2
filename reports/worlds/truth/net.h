#pragma once

#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** How the modes ẍ = −ω² x − 2 γ ẋ of a damped system die. */
struct Decay {
  double half_damping = 0;           ///< γ. [1/s]
  std::vector<double> frequencies2;  ///< ω² of each mode, ascending. [1/s²]

  /** Returns how fast the slowest mode dies: γ, or γ − √(γ² − ω²) where that is slower.
   [1/s] */
  double Slowest() const;

  /** Returns the most that is left of (x, ẋ/ω) after `t` [s], over the modes and over all
   starts of that size: e^(−γ t + asinh(γ S)), S = sinh(μ t)/μ with μ² = γ² − ω², or the
   largest so far of |sin(ν t)|/ν with ν² = ω² − γ². It is the greatest singular value of
   the solution e^(−γ t) (C + S B), B² = μ², which has determinant e^(−2γ t); damping that
   swings with the motion can leave more than e^(−γ t) for a while. [-] */
  double LeftAfter(double t) const;
};

/** Points under gravity that springs join: U = Σ ½ k (|p_b − p_a| − L)² − Σ m g·p. */
struct Net {
  /** A spring between two points. */
  struct Link {
    int a = 0;
    int b = 0;
    double stiffness = 0;    ///< [N/m]
    double rest_length = 0;  ///< [m]
    double damping = 0;      ///< [N s/m]; of no concern to the energy.
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

  /** Returns how small motions about the minimum `points_W` die where velocities decay at
   `damping` [1/s]. */
  Decay DecayAbout(const Points& points_W, double damping) const;
};

}  // namespace touchstone
