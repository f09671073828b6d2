#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "reports/sweep/tally.h"
#include "reports/writers/outcome.h"

namespace touchstone {

/** A judged answer to one question of a series. */
struct JudgedAnswer {
  std::uint64_t question;  ///< Index in the series.
  const Outcome& outcome;
  bool touching = false;   ///< A contact question that is certified as touching.
  bool undecided = false;  ///< A contact question that touches to within input rounding.
  /** Returns the value of a finding as a share of the question's size. [-] */
  std::function<double(const Finding&)> share_of;
  /** Returns the question as a scenario file. */
  std::function<std::string()> write;
};

/** Adds the answer to the results of its oracle. */
void CountAnswer(const JudgedAnswer& answer, OracleTally& tally);

}  // namespace touchstone
