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

/** What is accepted of one measure. */
struct Accepted {
  MeasureKind measure;
  /** Largest accepted value relative to SceneSize(), or absolute for dimensionless
   measures; of `touching` the separation, relative to SceneSize(). A worse value fails
   the run. 0 where the verdict has no value. */
  double bound = 0;
};

/** A known and accepted difference. */
struct LedgerEntry {
  std::string
      scenarios;  ///< Glob over scenario ids: '*' within a level, '**' across levels.
  std::string oracle;  ///< Exact oracle name.
  std::string
      version;  ///< Library version it was seen in; another version voids the entry.
  std::vector<Accepted> accepted;  ///< No measure twice.
  /** The verdict it excuses: kFail, kDisagree, kInvalid, kCrashed or kTimedOut. */
  Verdict verdict = Verdict::kFail;
  Cause cause = Cause::kDefect;
  std::string reason;  ///< One or two sentences: what goes wrong and why.
  std::string
      upstream;  ///< Link or issue "owner/repo#123"; "unreported" where there is none.
  std::string expires;  ///< ISO date after which the entry must be looked at again.
  /** The engine shows it in some runs and not in others, on one question: hiding nothing,
   or little, in one run is no improvement. */
  bool intermittent = false;
  int line = 0;  ///< Of the entry in its file.
};

/** What an entry did in a run. Both sides fail: exceeded, and no longer reproduced. */
struct LedgerUse {
  /** Of one measure. */
  struct Hidden {
    int findings = 0;  ///< That it made `known`.
    double worst = 0;  ///< Largest value among them, in the unit of the bound.
  };
  std::vector<Hidden> hidden;  ///< In the order of `accepted`.
  /** Findings in its scenarios, for its oracle and measures, whatever the verdict: an
   entry without candidates was not put to the test. */
  int candidates = 0;

  /** All findings that it made `known`. */
  int findings() const {
    return std::accumulate(hidden.begin(), hidden.end(), 0,
                           [](int sum, const Hidden& of) { return sum + of.findings; });
  }
};

/** The known discrepancies, scenarios/known_discrepancies.toml. */
struct Ledger {
  std::filesystem::path file;
  std::vector<LedgerEntry> entries;
  /** Ids of scenarios that no entry is about, whatever its glob matches: they are not of
   the catalogue that the ledger was written for. */
  std::set<std::string, std::less<>> strangers;
};

}  // namespace touchstone
