#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/clusters/shares.h"
#include "reports/finding/ledger.h"
#include "reports/run_report.h"

namespace touchstone {

/** The size of a fault to a user, from the mildest to the gravest. The order is that of
 Grade; an answer that crashed, timed out or is invalid counts as a wrong one, unless a
 normal off unit length is all. */
enum class Band {
  kNone,      ///< No fault, or one without a size.
  kRounding,  ///< At most 1e-6 of the size.
  kSmall,     ///< Over 1e-6.
  kLarge,     ///< Over 1e-3.
  kGross,     ///< Over 10 %.
  kWrong,     ///< A wrong hit or miss, a body passed through, or no usable answer.
};

inline constexpr int kBands = static_cast<int>(Band::kWrong) + 1;

/** Returns "wrong answer", "over 10 %", …; "" for kNone. */
std::string_view NameOf(Band band);

/** Returns the band of a finding; kNone unless its verdict is a failure or known. A known
 finding has the band that it has without the ledger. A count of contacts, or a covered
 fraction of the patch, is at most kLarge: neither is a length by which anything is wrong.
 @param entries Those of the ledger that was applied.
 @param share See SharesOf(). [-] */
Band BandOf(const Finding& finding, std::span<const LedgerEntry> entries, double share);

/** Faults with one cause: those of one FaultOf() the ledger that its bounds excuse; those
 of one that they do not excuse any more; or those of one oracle, verdict, measure and
 cause outside the ledger. */
struct Cluster {
  std::string title;     ///< The fault as one sentence, with its stop.
  std::string reason;    ///< The ledger's for the worst finding, or the fault in words.
  std::string upstream;  ///< A link, "unreported", or "" outside the ledger.
  bool is_new = false;   ///< Whether it is not in the ledger.
  bool has_outgrown = false;   ///< Whether it is in the ledger, and larger than there.
  Band band = Band::kNone;     ///< The gravest.
  Cause cause = Cause::kNone;  ///< That of the worst finding.
  /** The party that the ledger entry of the worst finding names. Without an entry it is
   the model if that is the cause, and else the engine. */
  Responsible responsible = Responsible::kEngine;
  std::vector<std::size_t> findings;   ///< Indices, in the order of the report.
  std::vector<std::size_t> oracles;    ///< Those that share it, most findings first.
  std::vector<std::size_t> questions;  ///< Gravest first, then the most ordinary.
  /** The finding of the largest share among those over 10 % or wrong, else of the gravest
   band; a length before any other value. */
  std::size_t worst = 0;
  double error = 0;     ///< Value of the worst finding. [unit]
  std::string unit;     ///< "m" for a wrong hit or miss.
  double share = 0;     ///< Share of the worst finding. [-]
  double ordinary = 0;  ///< OrdinaryOf() its most ordinary question. [-]
  /** How much it matters to users, in bands: the largest band − (1 − ordinary) of its
   findings, with bands numbered from 0, plus log2(oracles) / 2 and log10(questions). A
   contrived question counts up to one band less; a fault that four engines share, or that
   ten questions show, counts one band more. [-] */
  double gravity = 0;
};

/** The clusters of a run. */
struct Clusters {
  /** Sorted by gravity, share, number of oracles and number of findings, in this order,
   each with the largest first. */
  std::vector<Cluster> ranked;
  std::vector<FindingPlace> places;  ///< Place of every finding.
  std::vector<double> shares;        ///< SharesOf() every finding. [-]
  std::vector<int> of_finding;       ///< Index into `ranked`, or −1.
};

/** Returns the clusters of everything that fails or is known. */
Clusters ClustersOf(const RunReport& report);

/** Returns whose a fault is, in how many scenarios, and its largest error: "Bullet and
 ODE, in 41 scenarios, at worst 4.8 cm, 5 % of the smaller body.". */
std::string ExtentOf(const RunReport& report, const Cluster& cluster);

/** Returns the oracles of a cluster in words: the libraries, or the oracles if all are of
 one library. */
std::string NamesOf(const RunReport& report, const std::vector<std::size_t>& oracles);

}  // namespace touchstone
