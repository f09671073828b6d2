#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scenarios/measure_kind.h"

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

/** One oracle, one scenario, one measure: a number and what it means. */
struct Finding {
  std::string scenario;
  std::string oracle;
  /** The oracle whose answer is the other side; "referee" for the certified truth, "law"
   for what is true of a world; empty for the metamorphic measures, which need none, and
   for what a changed world shows. */
  std::string reference;
  std::string law;  ///< The name of the law that the number is of, if there is one.
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

/** Returns whether the findings of one answer hold it against anything: the referee, a
 law, another engine; or its own variants, where no claim is left unverified. That it
 answered is no proof of anything, and what does not move at all does so in every frame.
 */
bool IsVerified(std::span<const Finding> of_one_answer);

/** Returns the legal model that a motion follows instead of the truth's, "simultaneous
 impacts": where it is recognised, its finding is beyond its tolerance and passes. Empty
 for every other finding. */
std::string_view RecognisedModelOf(const Finding& finding);

/** Returns "pass", "fail", …, "timed out". */
std::string_view NameOf(Verdict verdict);
/** Returns "convention", "tie", …; "" for kNone. */
std::string_view NameOf(Cause cause);

}  // namespace touchstone
