#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/triage/root.h"

namespace touchstone {

/** A root as the index lists it. */
struct IndexedRoot {
  const Root* root = nullptr;
  std::string folder;        ///< Relative to the index.
  bool is_new = false;       ///< Whether the ledger has no fault like it.
  bool is_fresh = false;     ///< Whether an earlier triage did not have it.
  std::string program = {};  ///< "shows it", "not run", "none", …
};

/** The index of a triage. */
struct TriageIndex {
  std::string source;              ///< The file that was read.
  std::string asked;               ///< The oracles that were asked, with their versions.
  std::uint64_t failed = 0;        ///< Same as Failures::failed.
  std::uint64_t unproved = 0;      ///< Same as Failures::unproved.
  std::uint64_t vanished = 0;      ///< Same as Failures::vanished.
  std::uint64_t unasked = 0;       ///< Same as Failures::unasked.
  std::vector<IndexedRoot> roots;  ///< In the order of RootsOf().
  std::vector<Specimen> unrepeatable;
  std::size_t left_out = 0;   ///< Symptoms that were not examined.
  bool is_search = false;     ///< Whether questions depend on the answers (--climb).
  bool has_baseline = false;  ///< Whether is_fresh means anything.
};

/** Returns index.md: a table of the roots, those that are fresh first, and how many of
 the failures they have. */
std::string IndexPage(const TriageIndex& index);

/** Returns the roots as lines for a console: rank, rate, title. */
std::string SummaryOf(const TriageIndex& index);

/** Returns roots.txt: the keys of the roots, one a line, for a later triage. */
std::string KeysFile(const std::vector<Root>& roots);

/** Returns the lines of a root in roots.txt, without their ends: one for each of its
 failures, so that what goes wrong anew in a function that was wrong before is new. They
 have no version: a fault that an update of the library leaves as it was is not new. */
std::vector<std::string> KeyLinesOf(const Root& root);

}  // namespace touchstone
