#pragma once

#include <string>

#include "oracles/oracle.h"
#include "reports/contacts/contact_result.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/world_result.h"

namespace touchstone {

/** A fault as files for the engine's own developers. */
struct Reproduction {
  std::string program;  ///< reproduce.cc, against the engine's own API alone.
  std::string build;    ///< CMakeLists.txt
  std::string title;    ///< The fault in a line, without a stop.
  /** The sections of REPORT.md after the title: the question, the answer with its proof,
   and how to build and run the program. */
  std::string report;
};

/** Returns the program that puts the question of `result` to the engine of `oracle`. It
 exits 1 if `finding` is still there, 0 if it is gone. Throws CannotReproduce.
 @pre `finding` is one of the first oracle of `result`. */
Reproduction Reproduce(const ScenarioResult& result, const OracleInfo& oracle,
                       const Finding& finding);

/** The same for a world: the program simulates the world of `result` in the engine. */
Reproduction Reproduce(const WorldResult& result, const OracleInfo& oracle,
                       const Finding& finding);

/** Returns REPORT.md of files whose program has not been run yet. */
std::string ReportFile(const Reproduction& files);

}  // namespace touchstone
