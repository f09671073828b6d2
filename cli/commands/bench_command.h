#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/select_oracles.h"
#include "cli/session.h"

namespace touchstone {

/** The arguments of `touchstone bench contact`. */
struct BenchArguments {
  std::vector<std::string> oracles;  ///< Names or groups ("fcl"); empty: all.
  /** Names of two shapes; empty: the three pairs of spheres and boxes. */
  std::vector<std::string> pair;
  std::uint64_t count = 20000;  ///< Questions per pair.
  std::uint64_t sample = 500;   ///< Number of questions checked against the truth.
  std::uint64_t seed = 1;
};

/** Prints, per pair of shapes and oracle, the time of a query and the accuracy of the
 answers. The time is the median of several passes over the same random poses, with the
 engine objects created beforehand. The oracles take turns. */
int BenchCommand(const Session& session, const BenchArguments& arguments);

}  // namespace touchstone
