#pragma once

#include <array>
#include <string_view>

#include "reports/worlds/truth/torque_free_rotation.h"

namespace touchstone {

/** The first-order schemes by which engines integrate Euler's equations. L = R I Rᵀ ω
 with the orientation at the start of the step. */
enum class GyroscopicScheme {
  kExplicit,          ///< I (ω' − ω) = −h ω × L.
  kImplicit,          ///< I (ω' − ω) = −h ω' × I ω', solved to rounding.
  kLinearlyImplicit,  ///< I ω' = L − h ω' × L.
  kMomentum,  ///< Rotates by ω, then ω' = R I⁻¹ Rᵀ L with the L of the start.
};

inline constexpr std::array<GyroscopicScheme, 4> kGyroscopicSchemes = {
    GyroscopicScheme::kExplicit, GyroscopicScheme::kImplicit,
    GyroscopicScheme::kLinearlyImplicit, GyroscopicScheme::kMomentum};

/** Returns "explicit gyroscopic term", … */
std::string_view NameOf(GyroscopicScheme scheme);

/** A free body stepped by one of the schemes. The orientation is then advanced by h ω' as
 q' ∝ q + ½ h ω' q, normalised. The difference from the exact rotation, ω³h²t/12, also
 belongs to the error of the order of the step. */
class SteppedRotation {
 public:
  SteppedRotation(GyroscopicScheme scheme, const Eigen::Vector3d& inertia,
                  const Rotation& start, double dt);

  /** Advances by one step. */
  void Step();

  const Rotation& state() const { return state_; }

 private:
  Eigen::Vector3d NextSpin() const;

  GyroscopicScheme scheme_;
  Eigen::Vector3d inertia_;
  double dt_;
  Rotation state_;
  Eigen::Vector3d L_W_;
};

}  // namespace touchstone
