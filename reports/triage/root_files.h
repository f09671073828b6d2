#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/reproduce/reproduction.h"
#include "reports/triage/root.h"

namespace touchstone {

/** Returns case.toml: the smallest question as a scenario file that indicts the oracle,
 with that id. */
std::string CaseFile(const Root& root, const std::string& id);

/** Returns original.toml: the question that it was shrunk from, with that id. */
std::string OriginalFile(const Root& root, const std::string& id);

/** A program that shows a root, or why there is none. */
struct RootProgram {
  std::optional<Reproduction> files;
  std::string reason;  ///< Why there is none, without a stop.
};

/** Returns the program for the smallest question of a root. */
RootProgram ProgramOf(const Root& root);

/** How the building and running of a program ended. */
enum class ProgramEnding {
  kShowsFault,  ///< Exit code 1.
  kShowsNone,   ///< Exit code 0.
  kNotBuilt,
  kUnfinished,  ///< Killed, or out of time.
};

/** The output of a program, and how it ended. */
struct ProgramOutput {
  std::string text;
  ProgramEnding ending = ProgramEnding::kNotBuilt;
};

/** Returns REPORT.md, a text for the tracker of the library: what was asked, the answer
 with its proof, the output of the program, how common it is, and whether it is known.
 @param output Empty if the program was not run.
 @param known KnownFaultsLike() it. */
std::string ReportOf(const Root& root, const RootProgram& program,
                     const std::optional<ProgramOutput>& output,
                     const std::vector<std::string>& known);

}  // namespace touchstone
