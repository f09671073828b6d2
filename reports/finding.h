#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace touchstone {

/** What a measure's value means for the oracle that gave it. */
enum class Verdict {
  kPass,         ///< Within the derived tolerance of the certified truth.
  kFail,         ///< Proved wrong.
  kDisagree,     ///< Differs from the others, unproved.
  kKnown,        ///< Proved wrong, and listed in the ledger.
  kUndecidable,  ///< Inside the certified error band: nobody can be wrong.
  kUnsupported,  ///< The oracle has no such query.
  kCrashed,      ///< The engine died on the question.
  kTimedOut,     ///< The engine did not answer in time.
  kInvalid,      ///< NaN, infinite, non-unit normal, contact without a point.
};

/** Why an answer differs. */
enum class Cause {
  kNone,        ///< It does not.
  kConvention,  ///< A known convention, applied, brings it to the truth.
  kTie,         ///< Another answer is equally right.
  kPrecision,   ///< The engine's arithmetic: rounding the input at the engine's precision
                ///< moves the truth, or its answer, as much as the error.
  kDiscretisation,  ///< The step: the error vanishes as dt does.
  kModel,   ///< A documented model (rounded corners, a margin) answers another question.
  kDefect,  ///< None of these.
};

/** The comparable numbers of an answer. Each is one small function in reports/measures/
 or reports/worlds/, which holds formula, unit and source. */
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
  kHeading,               ///< Change when the world is turned about gravity. [m]
  kTranslation,           ///< Change when the world is moved. [m]
  kMirror,                ///< Change when the world is mirrored. [m]
  kPermutation,           ///< Change when the bodies are listed in another order. [m]
  kMassScaling,           ///< Change when all masses are scaled. [m]
};

inline constexpr int kMeasureKinds = static_cast<int>(MeasureKind::kMassScaling) + 1;

/** One oracle, one scenario, one measure: a number and what it means. */
struct Finding {
  std::string scenario;
  std::string oracle;
  /** The oracle whose answer is the other side; "referee" for the certified truth, empty
   for the metamorphic measures, which need none. */
  std::string reference;
  MeasureKind measure;
  double value = 0;
  double tolerance = 0;
  std::string tolerance_because;  ///< The origin of the tolerance, one sentence.
  Verdict verdict = Verdict::kPass;
  Cause cause = Cause::kNone;
  std::string cause_because;  ///< E.g. "depth is half the overlap along its own normal".
  /** The proof as a sentence: "fcl/collide says 0.0135 along n; moving B by 0.01341 along
   m separates them." Empty for passes. */
  std::string proof;
  /** The ledger entry that makes it `known`: its index in the ledger file. */
  std::optional<int> ledger_entry;
};

/** Returns the name used in tables and files: "separation_error", "touching", … */
std::string_view NameOf(MeasureKind measure);
/** Returns "pass", "fail", …, "timed out". */
std::string_view NameOf(Verdict verdict);
/** Returns "convention", "tie", …; "" for kNone. */
std::string_view NameOf(Cause cause);
/** Returns "m", "rad" or "". */
std::string_view UnitOf(MeasureKind measure);

}  // namespace touchstone
