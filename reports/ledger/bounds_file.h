#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/finding/ledger.h"
#include "scenarios/diagnostic.h"

namespace touchstone {

/** The bounds of a ledger, or all errors of their file. */
struct BoundsResult {
  std::optional<LedgerBounds>
      bounds;  ///< Present if and only if there are no diagnostics.
  std::vector<Diagnostic> diagnostics;
};

/** Returns the file of the bounds of a ledger: its name with the extension ".bounds". */
std::filesystem::path BoundsFileOf(const std::filesystem::path& ledger);

/** Reads bounds. A line has a scenario, an oracle and the bounds of its measures, in
 words separated by blanks:

   contact/zoo/fcl_508y fcl/distance separation_error=0.051 duality_gap=0.2
   world/impact/row ode energy_drift:conserves_energy=0.4 answering=timed_out

 A bound is a number >= 0 or, for a verdict without a value, its name. A measure of a law
 is followed by ':' and the law. '#' starts a comment. In the name of an oracle "%20"
 stands for a blank; likewise for '%', '#' and control characters. `file` is the name used
 in diagnostics. */
BoundsResult ReadBounds(std::string_view text, const std::filesystem::path& file);

/** Reads the bounds from a file. A ledger without a file of bounds has none. */
BoundsResult ReadBoundsFile(const std::filesystem::path& file);

/** Returns the text of a file of bounds, sorted by scenario, oracle and measure. Bounds
 that are rounded by RoundedUp() read back the same.
 @param ledger Name of the ledger they belong to, for the comment at the top. */
std::string WriteBounds(const LedgerBounds& bounds, std::string_view ledger);

/** Returns whether the verdict of a finding has a value that a bound limits. */
bool HasValue(Verdict verdict);

/** Returns whether the values of `measure` are 0 or 1, or fractions, so that a bound
 above 1 would bound nothing. */
bool IsShare(MeasureKind measure);

/** Returns whether the values of `measure` are whole numbers. */
bool IsCount(MeasureKind measure);

}  // namespace touchstone
