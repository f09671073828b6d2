#pragma once

#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** Points with weight on a line of links between two fixed places, or from one. */
struct HangingChain {
  Eigen::Vector3d from_W;  ///< Where the first link is fixed. [m]
  Eigen::Vector3d to_W;    ///< Where the last one is; unused where the end is free.
  bool free_end = false;
  std::vector<Eigen::Vector3d> weight_W;  ///< m g of each point. [N]
  std::vector<double> rest_length;        ///< Of each link, one more than points. [m]
  std::vector<double> stiffness;          ///< Of each link; infinite: a rod. [N/m]
};

/** How it hangs. */
struct Catenary {
  std::vector<Eigen::Vector3d> points_W;   ///< [m]
  std::vector<Eigen::Vector3d> tension_W;  ///< Of each link, towards its end. [N]
};

/** Returns the chain at rest: each point between the links i and i + 1 has T_{i+1} = T_i
 − m g, and each link lies along its tension, L + |T|/k long. The one unknown, T of the
 first link, is where the links' sum meets `to_W`: the minimum of the convex Σ L |T_i| + ½
 |T_i|²/k − T_0·(to − from) over T_0, by Newton's method. For equal rods that is tan θ_i =
 (i − (n − 1)/2) m g/H, the discrete catenary.
 @pre The links reach from end to end, and the ends are not above each other. */
Catenary CatenaryOf(const HangingChain& chain);

}  // namespace touchstone
