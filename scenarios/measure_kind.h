#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace touchstone {

/** The measures: comparable numbers computed from an answer. A scenario names those that
 an engine reportedly gets wrong. Each is documented, with its formula, unit and source,
 where it is computed: reports/contacts/checks/, reports/measures/ or reports/worlds/. */
enum class MeasureKind {
  kTouching,             ///< 0: right, 1: wrong. [-]
  kSeparationError,      ///< |separation − truth|. [m]
  kConsistencyError,     ///< |depth − o(n)|: its depth against its own normal. [m]
  kExcess,               ///< o(n) − depth*: how much shorter the best direction is. [m]
  kDualityGap,           ///< |p_B − p_A| − support gap along its own direction. [m]
  kContactSurfaceError,  ///< Distance of p ∓ n s/2 from the surfaces. [m]
  kContactOffPatch,      ///< Distance of a deepest contact from the true patch. [m]
  kPatchCoverage,   ///< Fraction of the patch's extent that its contacts do not span. [-]
  kContactCount,    ///< Contacts missing, or in excess of what the patch needs. [-]
  kContactTooDeep,  ///< Depth of a contact in excess of the truth. [m]
  kContactSeparationError,  ///< How much deeper the bodies overlap at a contact than it
                            ///< says, or how far apart a contact is. [m]
  kWitnessError,            ///< |p_B − p_A − s n| of the witness points. [m]
  kMixedNormals,            ///< Largest angle between the normals of one manifold. [rad]
  kSwap,                    ///< Change when A and B are swapped. [m]
  kRigidMotion,             ///< Change when both move rigidly. [m]
  kScaling,       ///< Change, relative to the scale, when everything is scaled. [m]
  kRelabelling,   ///< Change when a box's axes are relabelled. [m]
  kPerturbation,  ///< Change in excess of what a tiny motion of B can cause. [m]
  kAnswering,     ///< 0: answered, 1: crashed, timed out, invalid or diverged. [-]
  // Measures of a trajectory: the largest value over its samples and its subjects.
  kPositionError,           ///< |p − p*|. [m]
  kOrientationError,        ///< Angle of q* q⁻¹. [rad]
  kVelocityError,           ///< |v − v*|. [m/s]
  kSpinError,               ///< |ω − ω*|. [rad/s]
  kMomentumDrift,           ///< |P − P*|: momentum without a cause. [N s]
  kAngularMomentumDrift,    ///< |L − L*| about the origin. [N m s]
  kEnergyDrift,             ///< Energy gained, or lost where it is conserved. [J]
  kMomentumBalance,         ///< |ΔP − Σ J − h Σ F| over a step. [N s]
  kAngularMomentumBalance,  ///< |ΔL − Σ r × J| about the centre over a step. [N m s]
  kTravelError,             ///< How far from any place that the velocities allow. [m]
  kTurnError,               ///< The same of a turn. [rad]
  kContactPlace,            ///< How far surfaces are from where a contact needs them. [m]
  kPenetration,             ///< Deepest overlap of two bodies. [m]
  kPassage,                 ///< Overlap on the way from one side to the other. [m]
  kRestMotion,     ///< Sinking, crawling and rising of a body that should rest. [m]
  kRestitution,    ///< |e − e*| of a bounce. [-]
  kFriction,       ///< |μ − μ*|, with μ inferred from the motion. [-]
  kConeViolation,  ///< |J_t| − μ J_n of a contact, for its friction cone. [N s]
  kJointError,     ///< | |p_AB| − L | of a distance joint. [m]
  kForceError,     ///< |F − F*| of a spring or a joint at rest. [N]
  kEventTime,      ///< How much too early or too late an event comes. [s]
  kObservedOrder,  ///< Deviation of the order of convergence from the scheme's. [-]
  kLimitError,     ///< Error of the limit as dt → 0. [m]
  kDeterminism,    ///< 0: two runs equal bit for bit, 1: not. [-]
  kStability,      ///< Change when the initial state is perturbed by a rounding. [m]
  kHeading,        ///< Change when the world is rotated about gravity. [m]
  kTranslation,    ///< Change when the world is translated. [m]
  kMirror,         ///< Change when the world is mirrored. [m]
  kPermutation,    ///< Change when the bodies are listed in another order. [m]
  kMassScaling,    ///< Change when all masses are scaled. [m]
};

inline constexpr int kMeasureKinds = static_cast<int>(MeasureKind::kMassScaling) + 1;

/** Returns the name used in tables and files: "separation_error", "touching", … */
std::string_view NameOf(MeasureKind measure);
/** Returns the unit, e.g. "m", "rad"; "" for a dimensionless measure. */
std::string_view UnitOf(MeasureKind measure);
/** Returns whether the measure is a number of contacts or the part of a patch that they
 leave out. Such a fault has no size that compares with a length. */
bool CountsContacts(MeasureKind measure);
/** Returns the measure with that name; empty if there is none. */
std::optional<MeasureKind> MeasureNamed(std::string_view name);
/** Returns every measure, in the order of the enumeration. */
std::vector<MeasureKind> AllMeasures();

}  // namespace touchstone
