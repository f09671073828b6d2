#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** An answer read by another convention, and that convention in words. */
struct Reading {
  ContactAnswer answer;
  std::string convention;  ///< E.g. "its normal points from B to A".
};

/** A separation must stand this many tolerances clear of zero before its sign, its scale
 or half of it can be told from chance: at 4, the smallest effect, half of it, is twice
 the tolerance. */
inline constexpr double kClearOfZero = 4;

/** Returns the answer as it would be if it had meant one of the conventions that engines
 are known to use, or two of them at once: normal from B to A; depth and distance with the
 other sign, halved or doubled; contacts on the surface of A or of B rather than midway.
 Only those that can bring the separation, or the overlap along the normal, to the truth;
 those that leave the answer alone are left out. The simpler come first. Source: the table
 of conventions in docs/conventions.md. */
std::vector<Reading> ReadingsOf(const Scenario& scenario, const ContactTruth& truth,
                                const OracleInfo& oracle, const ContactAnswer& answer);

/** Sets the cause of those failures among `findings`, all of one answer, that a reading
 repairs without breaking what passes. */
void ExplainByConvention(const Scenario& scenario, const ContactTruth& truth,
                         const OracleInfo& oracle, const ContactAnswer& answer,
                         std::vector<Finding*>& findings);

}  // namespace touchstone
