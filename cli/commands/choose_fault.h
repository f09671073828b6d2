#pragma once

#include <optional>
#include <string>

#include "cli/select_scenarios.h"
#include "cli/session.h"
#include "reports/shrink/shrink.h"

namespace touchstone {

/** The options by which a user chooses a fault. */
struct FaultSelection {
  ScenarioSelection scenarios;  ///< Must select one scenario.
  /** Name of an oracle or, if there is none of that name, of a group ("fcl"); empty:
   all. */
  std::string oracle;
  std::string measure;  ///< Name of a measure; empty: any.
  /** "MEASURE > NUMBER", in place of `measure`. */
  std::optional<std::string> keep;

  bool names_a_measure() const { return !measure.empty() || keep; }
};

/** A fault of an oracle in one scenario. */
struct ChosenFault {
  Question question;
  const Oracle* oracle;
  RunReport report;            ///< That of AskAlone(question, *oracle).
  Finding finding;             ///< The fault.
  std::optional<double> over;  ///< The number of FaultSelection::keep.
};

/** Returns the fault that `selection` means. If several oracles of the selection are
 wrong, it is that of the one that the file indicts. If several measures are wrong, it is
 the simplest proof of the gravest, Outcome::decisive. The ledger is not asked.

 Throws InputError if that is not one scenario, if nothing is wrong in it, and, with all
 their names, if several oracles are; also if `keep` cannot be read. */
ChosenFault ChooseFault(const Session& session, const FaultSelection& selection);

}  // namespace touchstone
