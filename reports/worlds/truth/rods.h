#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracles/trajectory.h"

namespace touchstone {

/** A massless rod between two points of a RodSystem, or from one to a fixed point. */
struct Rod {
  int a = 0;
  int b = -1;  ///< −1: fixed, at `p_W`.
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  double length = 0;  ///< [m], > 0
};

/** Points with mass that are held by rods, under gravity. */
struct RodSystem {
  std::vector<double> mass;  ///< [kg], > 0
  std::vector<Rod> rods;
  Eigen::Vector3d g_W;  ///< [m/s²]

  /** Returns the accelerations g + M⁻¹ Jᵀ λ, where λ ensures d·(a_b − a_a) = −|v_b −
   v_a|² for every rod d = p_b − p_a. [m/s²] */
  std::vector<Eigen::Vector3d> Accelerations(const std::vector<PointState>& state) const;

  /** Returns the motion after `t` [s], to about 1e-13 of its size. Gragg's method with
   its midpoint sums extrapolated to order 16 (Hairer, Nørsett, Wanner, Solving Ordinary
   Differential Equations I, 2nd ed., II.9), in steps of L/(50 max(√(g L), |v|)) for the
   shortest rod and the largest initial speed. A step is halved while its last two orders
   differ by more than 1e-12: a light mass between two taut rods snaps through faster than
   any initial speed tells. */
  std::vector<PointState> After(const std::vector<PointState>& start, double t) const;
};

/** A first-order scheme for rods: v += h g, then velocities along rods are removed, and x
 += h v. */
enum class RodScheme {
  kVelocity,   ///< Nothing else: rods grow by ½ v² h²/L per step.
  kBaumgarte,  ///< A fifth of the error per step is added to the velocity.
  kProjected,  ///< Positions are projected back onto the lengths.
};

inline constexpr std::array kRodSchemes = {RodScheme::kVelocity, RodScheme::kBaumgarte,
                                           RodScheme::kProjected};

/** Advances `state` by one step of `h` [s]. */
void StepRods(RodScheme scheme, const RodSystem& system, double h,
              std::vector<PointState>& state);

}  // namespace touchstone
