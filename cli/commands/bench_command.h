#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/select_oracles.h"
#include "cli/session.h"

namespace touchstone {

/** The arguments of `touchstone bench contact`. */
struct BenchArguments {
  std::vector<std::string> oracles;  ///< Names or what names begin with; empty: all.
  /** Two names of shapes; empty: the three pairs of spheres and boxes. */
  std::vector<std::string> pair;
  std::uint64_t count = 20000;  ///< Questions per pair.
  std::uint64_t sample = 500;   ///< Of these, how many are held against the truth.
  std::uint64_t seed = 1;
};

/** Prints, per pair of shapes and oracle, the time of a query (median of several passes,
 in turns, over the same random poses, engine objects made beforehand) and, beside it, how
 right the answers are. */
int BenchCommand(const Session& session, const BenchArguments& arguments);

}  // namespace touchstone
