#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "reports/finding/cited.h"
#include "reports/finding/proof.h"
#include "scenarios/measure_kind.h"

namespace touchstone {

/** The meaning of a measured value for the oracle it belongs to. */
enum class Verdict {
  kPass,         ///< Within the derived tolerance of the certified truth.
  kFail,         ///< Proved wrong.
  kDisagree,     ///< Differs from the others, unproved.
  kKnown,        ///< Proved wrong, and listed in the ledger.
  kUndecidable,  ///< No answer can be proved right or wrong; see Undecided.
  kUnsupported,  ///< The oracle does not answer such a query.
  kCrashed,      ///< The engine crashed on the question.
  kTimedOut,     ///< The engine did not answer in time.
  kInvalid,      ///< NaN, infinite, non-unit normal, contact without a point.
};

/** The reason why a finding is undecidable, from the mildest to the gravest. */
enum class Undecided {
  kAgreed,      ///< The sign is certified, and the answer agrees, within its rounding.
  kUnknown,     ///< The truth is not known well enough.
  kCoarse,      ///< Within a tolerance too wide to tell right from wrong.
  kUnverified,  ///< A field of the answer promises nothing that could be checked.
  kOpposed,     ///< The sign is certified, and the answer denies it, within its rounding.
};

/** How bad a fault is, from the mildest to the gravest. Console, page, sweeps and triage
 have no other scale. The numbers are shares of a size: of the smaller body for a length
 of a contact, see ShareOf() for others. Angles [rad], fractions and counts are compared
 directly. A fault without a size, such as a missing contact, is at most kLarge. */
enum class Grade {
  kNone,        ///< No fault.
  kRounding,    ///< At most 1e-6.
  kSmall,       ///< Over 1e-6.
  kLarge,       ///< Over 1e-3.
  kGross,       ///< Over 10 %.
  kWrongTouch,  ///< A wrong hit or miss by more than 1e-6, or a body passed through.
  kUnusable,    ///< A crash, a hang, or an answer that is invalid.
};

inline constexpr int kGrades = static_cast<int>(Grade::kUnusable) + 1;

/** The reason why an answer differs. */
enum class Cause {
  kNone,        ///< The answer does not differ, or its cause is unknown.
  kConvention,  ///< Converting from a known convention brings it to the truth.
  kTie,         ///< Several answers are equally right.
  kPrecision,  ///< The engine's arithmetic: the answer is right for an input that differs
               ///< by roundings.
  kDiscretisation,  ///< The time step: the error vanishes with dt.
  kModel,    ///< A documented model (rounded corners, a margin) solves another problem.
  kSetting,  ///< A setting that the adapter chose: as the engine ships, it passes.
  kDefect,   ///< None of these.
  kNotExamined,  ///< It was not sought: a sweep examines few of many similar failures.
};

/** Whether a fault of a motion depends on the settings that an adapter has chosen. */
enum class Shipped {
  kNotAsked,     ///< Not asked again, or set up as the engine ships.
  kBoth,         ///< It fails as the engine ships, too.
  kHereOnly,     ///< It passes as the engine ships.
  kShippedOnly,  ///< It passes here, and fails as the engine ships.
};

/** The errors of a motion at the step of its world, at a half and at a quarter of it. */
struct StepStudy {
  std::array<double, 3> errors{};  ///< [unit]
  std::string unit;                ///< "N" where the measure is an impulse of one step.
};

/** The value of one measure for one oracle in one scenario, and its meaning. */
struct Finding {
  std::string scenario;
  std::string oracle;
  /** The other side of the comparison: the name of an oracle; "referee" for the certified
   truth; "law" for a law of a world. Empty for the metamorphic measures, which need no
   reference, and for findings on a changed world. */
  std::string reference;
  std::string law;  ///< Name of the law that was measured; empty if there is none.
  /** Whether that law is judged of every motion and the world does not claim it. */
  bool universal = false;
  MeasureKind measure;
  double value = 0;
  double tolerance = 0;
  std::string tolerance_because;  ///< Origin of the tolerance, one sentence.
  Verdict verdict = Verdict::kPass;
  Undecided undecided = Undecided::kUnknown;  ///< Why it is undecidable, if it is.
  Grade grade = Grade::kNone;  ///< How bad the fault is; kNone if there is none.
  /** Factor of safety within `tolerance`; 1 if there is none. [-] */
  double safety = 1;
  Cause cause = Cause::kNone;
  std::string cause_because;  ///< E.g. "depth is half the overlap along its own normal".
  Shipped shipped = Shipped::kNotAsked;
  /** The value as shipped, and the setting that decides, as a sentence without a stop;
   empty if `shipped` is kNotAsked. */
  std::string shipped_because;
  /** The proof as a sentence, e.g. "fcl/collide says 0.0135 along n; moving B by 0.01341
   along m separates them." Empty for passes. */
  std::string proof;
  /** The numbers that `proof` is made of; null if it is words alone. Shared, since most
   findings have none. */
  std::shared_ptr<const Proof> evidence;
  /** The errors at smaller steps that its cause was told from, if it was. */
  std::optional<StepStudy> study;
  /** The parts of a world that `proof` names. Places of ProofKind::kPlaces are in
   `evidence` alone. */
  Cited cited;
  /** Index, in the ledger file, of the entry that makes it `known`. */
  std::optional<int> ledger_entry;
  /** Index, in the ledger file, of the entry that knows this fault, if the fault is now
   larger than its bound there. It is then a failure. */
  std::optional<int> outgrown_entry;
};

/** Makes `proof` that of `finding`: its sentence, its numbers, and for kPlaces what it
 cites. */
void State(Proof proof, Finding& finding);

/** Takes the proof of `finding` away. */
void TakeBackProof(Finding& finding);

/** Returns whether a verdict fails a run unless the ledger lists it: fail, disagree,
 crashed, timed out or invalid. */
bool IsFailure(Verdict verdict);

/** Returns whether an answer with that verdict is missing or of no use: crashed, timed
 out or invalid. */
bool IsUnusable(Verdict verdict);

/** Returns whether a value exceeds its tolerance by no more than the tolerance's factor
 of safety. Such a fault rests on the choice of that factor. */
bool IsWithinSafety(const Finding& finding);

/** Returns whether the verdict is `fail`. Such a failure has a cause to look for. */
inline bool IsProvedWrong(const Finding& finding) {
  return finding.verdict == Verdict::kFail;
}

/** Returns whether the findings of one answer compare it with anything: the referee, a
 law, another engine; or its own variants, provided that no claim is left unverified. The
 mere existence of an answer proves nothing, and a body that never moves passes every
 change of frame. An undecidable answer is not verified, whatever else of it passes. */
bool IsVerified(std::span<const Finding> of_one_answer);

/** Returns the legal model that a motion follows instead of the truth's, e.g.
 "simultaneous impacts". A finding of a recognised model passes although it exceeds its
 tolerance. Returns "" for every other finding. */
std::string_view RecognisedModelOf(const Finding& finding);

/** Returns "pass", "fail", …, "timed out". */
std::string_view NameOf(Verdict verdict);
/** Returns "sign known and agreed", "truth unknown", … */
std::string_view NameOf(Undecided undecided);
/** Returns "unusable", "wrong hit or miss", "over 10 %", …; "" for kNone. */
std::string_view NameOf(Grade grade);
/** Returns "both as set here and as shipped", "as set here only", …; "" for kNotAsked. */
std::string_view NameOf(Shipped shipped);
/** Returns "convention", "tie", …; "" for kNone. */
std::string_view NameOf(Cause cause);

}  // namespace touchstone
