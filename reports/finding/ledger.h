#pragma once

#include <filesystem>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "reports/finding/finding.h"

namespace touchstone {

/** The accepted difference of one measure. */
struct Accepted {
  MeasureKind measure;
  /** Largest accepted value, relative to SceneSize(); absolute for dimensionless
   measures. For `touching` it is the largest accepted |separation|, relative to
   SceneSize(). A worse value fails the run. 0 where the verdict has no value. */
  double bound = 0;
};

/** A known and accepted difference. */
struct LedgerEntry {
  /** Glob over scenario ids: '*' within a level, '**' across levels. */
  std::string scenarios;
  std::string oracle;  ///< Exact oracle name.
  /** Library version it was seen in. Another version voids the entry. */
  std::string version;
  std::vector<Accepted> accepted;  ///< Each measure at most once.
  /** The verdict it excuses: kFail, kDisagree, kInvalid, kCrashed or kTimedOut. */
  Verdict verdict = Verdict::kFail;
  Cause cause = Cause::kDefect;
  std::string reason;  ///< One or two sentences: what goes wrong and why.
  /** Link or issue "owner/repo#123"; "unreported" if there is none. */
  std::string upstream;
  std::string expires;  ///< ISO date after which the entry must be reviewed.
  /** Whether the engine shows it in some runs and not in others, on one question. A run
   in which the entry hides little or nothing is then no improvement. */
  bool intermittent = false;
  int line = 0;  ///< Line of the entry in its file.
};

/** The use of an entry in a run. A run fails both where an entry is exceeded and where it
 is no longer reproduced. */
struct LedgerUse {
  /** The findings of one measure that the entry hides. */
  struct Hidden {
    int findings = 0;  ///< Number of findings made `known`.
    double worst = 0;  ///< Largest hidden value, in the unit of the bound.
  };
  std::vector<Hidden> hidden;  ///< In the order of `accepted`.
  /** Number of findings in its scenarios, for its oracle and measures, whatever the
   verdict. An entry without candidates was not put to the test. */
  int candidates = 0;

  /** Returns the number of all findings that it made `known`. */
  int findings() const {
    return std::accumulate(hidden.begin(), hidden.end(), 0,
                           [](int sum, const Hidden& of) { return sum + of.findings; });
  }
};

/** The known discrepancies, scenarios/known_discrepancies.toml. */
struct Ledger {
  std::filesystem::path file;
  std::vector<LedgerEntry> entries;
  /** Ids of scenarios outside the catalogue that the ledger was written for: no entry
   applies to them, even if its glob matches. */
  std::set<std::string, std::less<>> outside_catalogue;
};

}  // namespace touchstone
