#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracles/trajectory.h"

namespace touchstone {

/** A massless rod between two points of a RodSystem, or from one to a fixed place. */
struct Rod {
  int a = 0;
  int b = -1;  ///< −1: fixed, at `p_W`.
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  double length = 0;  ///< [m], > 0
};

/** Points with mass that rods hold, under gravity. */
struct RodSystem {
  std::vector<double> mass;  ///< [kg], > 0
  std::vector<Rod> rods;
  Eigen::Vector3d g_W;  ///< [m/s²]

  /** Returns the accelerations: g + M⁻¹ Jᵀ λ, where λ keeps d·(a_b − a_a) = −|v_b − v_a|²
   of every rod d = p_b − p_a. [m/s²] */
  std::vector<Eigen::Vector3d> Accelerations(const std::vector<PointState>& state) const;

  /** Returns the motion after `t` [s], to some 1e-13 of its size: Gragg's method, its
   midpoint sums extrapolated to order 16 (Hairer, Nørsett, Wanner, Solving Ordinary
   Differential Equations I, 2nd ed., II.9), in steps of a fiftieth of √(L/g). */
  std::vector<PointState> After(const std::vector<PointState>& start, double t) const;
};

/** How an engine of first order keeps rods: v += h g, then velocities along rods are
 ended, and x += h v. */
enum class RodScheme {
  kVelocity,   ///< No more than that: rods grow by ½ v² h²/L a step.
  kBaumgarte,  ///< A fifth of the error a step is added to the velocity.
  kProjected,  ///< Positions are put back onto the lengths.
};

inline constexpr std::array kRodSchemes = {RodScheme::kVelocity, RodScheme::kBaumgarte,
                                           RodScheme::kProjected};

/** Advances `state` by one step of `h` [s]. */
void StepRods(RodScheme scheme, const RodSystem& system, double h,
              std::vector<PointState>& state);

}  // namespace touchstone
