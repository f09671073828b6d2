#pragma once

#include <string>
#include <vector>

#include "cli/session.h"
#include "reports/bench/contact_bench.h"

namespace touchstone {

/** The arguments of `touchstone bench contact`. */
struct BenchArguments {
  std::vector<std::string> oracles;  ///< Names or groups ("fcl"); empty: all.
  /** Names of two shapes; empty: the three pairs of spheres and boxes. */
  std::vector<std::string> pair;
  ContactBenchSettings questions;
};

/** Prints, per pair of shapes and oracle, the time of a query and the accuracy of the
 answers. The time is the median of several passes over the same random poses, with the
 engine objects created beforehand. The oracles take turns. */
int BenchCommand(const Session& session, const BenchArguments& arguments);

}  // namespace touchstone
