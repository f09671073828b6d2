#pragma once

#include <string>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/reproduce/engine_code.h"

namespace touchstone {

/** Returns the library, its version and what it does wrong, without a stop. */
std::string TitleOf(const OracleInfo& oracle, const Finding& finding);

/** Returns the CMakeLists.txt that builds reproduce.cc. */
std::string BuildFile(const EngineCode& engine);

/** The parts of a report that depend on the kind of question. */
struct ReportParts {
  std::string asked;  ///< The bodies or the world, as sentences.
  std::string truth;  ///< The right answer as a sentence; may be empty.
};

/** Returns Reproduction::report. */
std::string ReportOf(const ReportParts& parts, const OracleInfo& oracle,
                     const EngineCode& engine, const Finding& finding);

}  // namespace touchstone
