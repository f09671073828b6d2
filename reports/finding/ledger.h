#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "reports/finding/finding.h"

namespace touchstone {

/** The findings that one bound is about: those of one measure, by one law, of one oracle
 in one scenario. */
struct LedgerCell {
  std::string scenario;
  std::string oracle;
  MeasureKind measure;
  std::string law;  ///< Law of the findings; empty where no law is measured.

  friend auto operator<=>(const LedgerCell&, const LedgerCell&) = default;
};

/** The accepted findings of one cell. */
struct LedgerBound {
  /** kFail for the verdicts with a value; otherwise the only accepted verdict: kInvalid,
   kCrashed or kTimedOut. */
  Verdict verdict = Verdict::kFail;
  /** Largest accepted value, in the unit of ValueForLedger(). 0 without a value. */
  double value = 0;
  int line = 0;  ///< Line in the file of bounds.
};

/** The bounds of a ledger, sorted. */
using LedgerBounds = std::map<LedgerCell, LedgerBound>;

/** The party that is responsible for a known difference. */
enum class Responsible {
  kEngine,   ///< The engine: its answer is wrong.
  kAdapter,  ///< The adapter: a setting that it chooses, and that other users need not.
  kModel,    ///< A simplification that the engine documents, or a law of its own.
};

/** Returns "engine", "adapter" or "model". */
std::string_view NameOf(Responsible responsible);

/** A known and accepted difference. */
struct LedgerEntry {
  /** Globs over scenario ids: '*' within a level, '**' across levels. */
  std::vector<std::string> scenarios;
  std::string oracle;  ///< Exact oracle name.
  /** Library version it was seen in. Another version voids the entry. */
  std::string version;
  std::vector<MeasureKind> measures;  ///< In the order of the enumeration, each once.
  /** The verdict it excuses: kFail, kDisagree, kInvalid, kCrashed or kTimedOut. */
  Verdict verdict = Verdict::kFail;
  std::vector<Cause> causes;  ///< Those of its findings, each once.
  /** The fault as one sentence; entries with the same one have the same cause. Empty for
   the first sentence of the reason. */
  std::string fault;
  std::string reason;  ///< One or two sentences: what goes wrong and why.
  /** Link or issue "owner/repo#123"; "unreported" if there is none. */
  std::string upstream;
  std::string expires;  ///< ISO date after which the entry must be reviewed.
  Responsible responsible = Responsible::kEngine;
  /** Whether the engine shows it in some runs and not in others, on one question. A run
   in which the entry hides little or nothing is then no improvement. */
  bool intermittent = false;
  /** Whether a length may be wrong by the size of the scene or more. */
  bool beyond_scene = false;
  int line = 0;  ///< Line of the entry in its file.
};

/** Returns the fault of an entry as one sentence with its stop: its `fault`, or the first
 sentence of its reason. */
std::string FaultOf(const LedgerEntry& entry);

/** Returns the causes of an entry in words, e.g. "precision, defect". */
std::string CausesOf(const LedgerEntry& entry);

/** The use of an entry in a run. */
struct LedgerUse {
  /** The findings of one measure that the entry hides. */
  struct Hidden {
    int findings = 0;  ///< Number of findings made `known`.
    double worst = 0;  ///< Largest hidden value, in the unit of its bound.
    double bound = 0;  ///< Bound of the worst. [as `worst`]
  };
  std::vector<Hidden> hidden;  ///< In the order of the entry's measures.
  /** Number of hidden findings of each cause. */
  std::map<Cause, int> causes;
  /** Number of findings in its scenarios, for its oracle and measures, whatever the
   verdict. An entry without candidates was not put to the test. */
  int candidates = 0;
  /** Whether the library has another version than the entry, so that the entry excuses
   nothing. */
  bool voided = false;
  bool beyond_scene = false;  ///< Whether a bound that hid something is that large.

  /** Returns the number of all findings that it made `known`. */
  int findings() const {
    return std::accumulate(hidden.begin(), hidden.end(), 0,
                           [](int sum, const Hidden& of) { return sum + of.findings; });
  }
};

/** The known discrepancies. Their texts, scenarios/known_discrepancies.toml, are written
 by hand, their bounds, the file next to it, by `touchstone ledger --update`. A finding is
 known if an entry covers it and it keeps within the bound of its cell. */
struct Ledger {
  std::filesystem::path file;
  std::vector<LedgerEntry> entries;
  LedgerBounds bounds;
  /** Ids of scenarios outside the catalogue that the ledger was written for: no entry
   applies to them, even if its glob matches. */
  std::set<std::string, std::less<>> outside_catalogue;
};

}  // namespace touchstone
