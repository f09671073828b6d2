#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "reports/run_report.h"

namespace touchstone {

/** The place of a finding in its report. */
struct FindingPlace {
  std::size_t question = 0;  ///< Index, see IdOf(report, i).
  std::size_t oracle = 0;    ///< Index into RunReport::oracles.
};

/** Returns the place of every finding of `report`. */
std::vector<FindingPlace> PlacesOf(const RunReport& report);

/** Returns the value of every finding as a share of the size of its question, see
 ShareOf(). [-] */
std::vector<double> SharesOf(const RunReport& report,
                             const std::vector<FindingPlace>& places);

/** Returns the length by which errors on question `i` are divided: the extent of the
 smaller body, or the length of the scale of the first whole motion. [m] */
double SizeOfQuestion(const RunReport& report, std::size_t i);

/** Returns what has the length of SizeOfQuestion(), as words that follow "5 % of": "the
 smaller body", "the smallest moving body" of a world, "the extent of its points" of a
 world without moving bodies. */
std::string_view SizedPartOf(const RunReport& report, std::size_t i);

}  // namespace touchstone
