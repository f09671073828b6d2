#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/select_oracles.h"
#include "cli/session.h"

namespace touchstone {

/** The arguments of `touchstone sweep contact`. */
struct SweepArguments {
  OracleSelection oracles;
  std::string family = "all";  ///< Name of a Family, or "all".
  std::vector<std::string>
      pair;  ///< Two names of shapes; empty: all that the subject supports.
  std::uint64_t count = 200;  ///< Questions per family and pair.
  std::uint64_t first = 0;
  std::uint64_t seed = 1;
  std::optional<std::filesystem::path>
      out;  ///< Folder for the failed questions, as TOML.
  int jobs = 0;
  bool quiet = false;
};

/** Asks the subject generated questions and prints, per family and pair, the share that
 touched, the failures and the worst measures relative to their tolerances; then the first
 failures with proof. Returns 1 on failures, 2 where nothing touched. */
int SweepCommand(const Session& session, const SweepArguments& arguments);

/** Returns the kinds of those two names. Throws InputError for unknown names, with the
 nearest, and for two half-spaces, which are no question. */
std::pair<ShapeKind, ShapeKind> PairNamed(const std::vector<std::string>& names);

}  // namespace touchstone
