#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace touchstone {

/** The comparable numbers of an answer. A scenario names those that an engine is said to
 get wrong; each is one small function in reports/measures/ or reports/worlds/, which
 holds formula, unit and source. */
enum class MeasureKind {
  kTouching,          ///< 0 right, 1 wrong. [-]
  kSeparationError,   ///< |separation − truth|. [m]
  kConsistencyError,  ///< |depth − o(n)|: does its depth agree with its own normal. [m]
  kExcess,            ///< o(n) − depth*: how much shorter another direction is. [m]
  kDualityGap,        ///< |p_B − p_A| − support gap along its own direction. [m]
  kContactSurfaceError,  ///< How far p ∓ n s/2 are from the surfaces. [m]
  kContactOffPatch,      ///< How far a deepest contact lies outside the true patch. [m]
  kPatchCoverage,   ///< Share of the patch's extent left unspanned by its contacts. [-]
  kContactCount,    ///< Contacts short of, or beyond, what the patch needs. [-]
  kContactTooDeep,  ///< How much a contact is deeper than the truth. [m]
  kMixedNormals,    ///< Largest angle between the normals of one manifold. [rad]
  kSwap,            ///< Change when A and B are swapped. [m]
  kRigidMotion,     ///< Change when both move rigidly. [m]
  kScaling,         ///< Change, relative to the scale, when everything is scaled. [m]
  kRelabelling,     ///< Change when a box's axes are relabelled. [m]
  kPerturbation,    ///< Change beyond what a tiny motion of B can cause. [m]
  kAnswering,       ///< 0 answered, 1 crashed, timed out, invalid or diverged. [-]
  // Of a trajectory; the largest over its samples and what it is about.
  kPositionError,         ///< |p − p*|. [m]
  kOrientationError,      ///< Angle of q* q⁻¹. [rad]
  kVelocityError,         ///< |v − v*|. [m/s]
  kSpinError,             ///< |ω − ω*|. [rad/s]
  kMomentumDrift,         ///< |P − P*|: momentum that nothing explains. [N s]
  kAngularMomentumDrift,  ///< |L − L*| about the origin. [N m s]
  kEnergyDrift,           ///< Energy gained, or lost where none may be. [J]
  kMomentumBalance,       ///< |ΔP − Σ J − h Σ F| of a step. [N s]
  kPenetration,           ///< Deepest overlap of two bodies. [m]
  kRestMotion,            ///< Sinking, crawling and rising of what should rest. [m]
  kRestitution,           ///< |e − e*| of a bounce. [-]
  kFriction,              ///< |μ − μ*| as the motion shows it. [-]
  kConeViolation,         ///< |J_t| − μ J_n of a contact, by its cone. [N s]
  kJointError,            ///< | |p_AB| − L | of a distance joint. [m]
  kForceError,            ///< |F − F*| of a spring or a joint at rest. [N]
  kObservedOrder,         ///< How far the order of convergence is from the scheme's. [-]
  kLimitError,            ///< Error of the limit as dt → 0. [m]
  kDeterminism,           ///< 0 two runs alike bit for bit, 1 not. [-]
  kStability,             ///< Change when the start is moved by a rounding. [m]
  kHeading,               ///< Change when the world is turned about gravity. [m]
  kTranslation,           ///< Change when the world is moved. [m]
  kMirror,                ///< Change when the world is mirrored. [m]
  kPermutation,           ///< Change when the bodies are listed in another order. [m]
  kMassScaling,           ///< Change when all masses are scaled. [m]
};

inline constexpr int kMeasureKinds = static_cast<int>(MeasureKind::kMassScaling) + 1;

/** Returns the name used in tables and files: "separation_error", "touching", … */
std::string_view NameOf(MeasureKind measure);
/** Returns "m", "rad" or "". */
std::string_view UnitOf(MeasureKind measure);
/** Returns the measure of that name. */
std::optional<MeasureKind> MeasureNamed(std::string_view name);
/** Returns every measure, in the order of the enumeration. */
std::vector<MeasureKind> AllMeasures();

}  // namespace touchstone
