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
      pair;  ///< Names of two shapes; empty: all pairs that the subject supports.
  std::uint64_t count = 200;  ///< Questions per family and pair.
  std::uint64_t first = 0;
  std::uint64_t seed = 1;
  std::optional<std::filesystem::path>
      out;  ///< Folder for the failed questions, as TOML.
  int jobs = 0;
  bool quiet = false;
};

/** Runs generated questions on the subject. Prints, per family and pair, the fraction
 that touches, the failures and the worst measures relative to their tolerances; then the
 first failures with proofs. Returns 1 on failures, 2 if no question that the subject
 supports touched, else 0. */
int SweepCommand(const Session& session, const SweepArguments& arguments);

/** Returns the shape kinds of two names. Throws InputError for an unknown name, with the
 nearest, and for two half-spaces, which are not a valid question. */
std::pair<ShapeKind, ShapeKind> PairNamed(const std::vector<std::string>& names);

}  // namespace touchstone
