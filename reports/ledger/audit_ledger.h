#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "reports/run_report.h"

namespace touchstone {

/** The error, as a fraction of the scene, that the audit looks for. [-] */
inline constexpr double kSoughtError = 1e-3;

/** The least share of cells in which the sought error must be seen. [-] */
inline constexpr double kLeastSeen = 0.995;

/** The fraction of the scene above which a bound is listed. [-] */
inline constexpr double kLargeBound = 0.1;

/** The faults that a ledger hides in a run, and the errors that it could hide. */
struct LedgerAudit {
  /** A cause that an entry does not name although findings have it, or names although
   none has it. */
  struct Contradiction {
    std::size_t entry;
    Cause cause;
    int findings;  ///< Number of hidden findings with that cause.
  };
  /** A bound of a length of a contact query above kLargeBound of the scene. */
  struct Large {
    LedgerCell cell;
    double bound;
  };

  int hidden = 0;  ///< Findings made `known`.
  /** Length findings of references in contact queries that pass. */
  int passing = 0;
  /** Those in which the ledger would excuse an error of kSoughtError of the scene. */
  int excusable = 0;
  /** Those whose own tolerance allows such an error. The ledger
   excuses none of them. */
  int tolerated = 0;
  std::vector<Contradiction> contradictions;
  std::vector<Large> large;  ///< The largest first.

  /** Returns the share of passing cells in which the ledger would not hide the sought
   error; 1 if there are none. [-] */
  double Seen() const { return passing == 0 ? 1 : 1 - double(excusable) / passing; }
};

/** Audits the ledger of a report to which it has been applied. In a `partial` run an
 entry may name causes that only the findings left out have. */
LedgerAudit AuditLedger(const RunReport& report, bool partial = false);

/** Writes an audit: the share of Seen(), large bounds, contradictions of causes, the
 oldest date of expiry, and the findings that each entry hides, if the run tested it. */
void WriteAudit(const RunReport& report, const LedgerAudit& audit, std::ostream& out);

/** Returns what is not in order in an audit, one sentence each: too little is seen, or a
 cause contradicts. */
std::vector<std::string> FaultsOf(const RunReport& report, const LedgerAudit& audit);

/** Returns whether an audit is in order: there are no such faults. */
bool IsInOrder(const LedgerAudit& audit);

}  // namespace touchstone
