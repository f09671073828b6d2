#pragma once

#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** A chain of weighted points, joined by links, that hangs between two fixed points or
 from one. */
struct HangingChain {
  Eigen::Vector3d from_W;  ///< The fixed end of the first link. [m]
  /** The fixed end of the last link; unused if the end is free. [m] */
  Eigen::Vector3d to_W;
  bool free_end = false;
  std::vector<Eigen::Vector3d> weight_W;  ///< m g of each point. [N]
  /** Indexed by link; one more than points, or as many with a free end. [m] */
  std::vector<double> rest_length;
  std::vector<double> stiffness;  ///< Indexed by link; infinite: a rod. [N/m]
};

/** The shape and the tensions of a chain at rest. */
struct Catenary {
  std::vector<Eigen::Vector3d> points_W;   ///< Positions of the points. [m]
  std::vector<Eigen::Vector3d> tension_W;  ///< Indexed by link, towards its end. [N]
};

/** Returns the chain at rest. Each point between the links i and i + 1 has T_{i+1} = T_i
 − m g, and each link lies along its tension with the length L + |T|/k.

 The one unknown is T_0, the tension of the first link, with which the sum of the links
 reaches `to_W`. It is the minimum of the convex Σ L |T_i| + ½ |T_i|²/k − T_0·(to − from)
 over T_0, found by Newton's method. For equal rods that is tan θ_i = (i − (n − 1)/2) m
 g/H, the discrete catenary.

 @pre The links reach from end to end, and neither end is right above the other. */
Catenary CatenaryOf(const HangingChain& chain);

}  // namespace touchstone
