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

/** Faults with one cause: those of one FaultOf() the ledger that its bounds excuse; those
 of one that they do not excuse any more; or those of one oracle, verdict, measure and
 cause outside the ledger. */
struct Cluster {
  std::string title;     ///< The fault as one sentence, with its stop.
  std::string reason;    ///< The ledger's for the worst finding, or the fault in words.
  std::string upstream;  ///< A link, "unreported", or "" outside the ledger.
  bool is_new = false;   ///< Whether it is not in the ledger.
  bool has_outgrown = false;   ///< Whether it is in the ledger, and larger than there.
  Grade grade = Grade::kNone;  ///< The gravest.
  Cause cause = Cause::kNone;  ///< That of the worst finding.
  /** The party that the ledger entry of the worst finding names. Without an entry it is
   the model if that is the cause, and else the engine. */
  Responsible responsible = Responsible::kEngine;
  std::vector<std::size_t> findings;   ///< Indices, in the order of the report.
  std::vector<std::size_t> oracles;    ///< Those that share it, most findings first.
  std::vector<std::size_t> questions;  ///< Gravest first, then the most ordinary.
  /** The finding of the largest share among those over 10 % and graver, else of the
   gravest grade; a length before any other value. */
  std::size_t worst = 0;
  double error = 0;     ///< Value of the worst finding. [unit]
  std::string unit;     ///< "m" for a wrong hit or miss.
  double share = 0;     ///< Share of the worst finding. [-]
  double ordinary = 0;  ///< OrdinaryOf() its most ordinary question. [-]
  /** How much it matters to users, in grades: the largest grade − (1 − ordinary) of its
   findings, with grades numbered from 0, plus log2(oracles) / 2 and log10(questions). A
   contrived question counts up to one grade less; a fault that four engines share, or
   that ten questions show, counts one grade more. [-] */
  double rank = 0;
};

/** The clusters of a run. */
struct Clusters {
  /** Sorted by rank, share, number of oracles and number of findings, in this order,
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
