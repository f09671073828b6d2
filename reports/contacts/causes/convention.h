#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** An answer as it reads in another convention, and the name of that convention. */
struct Reading {
  ContactAnswer answer;
  std::string convention;  ///< E.g. "its normal points from B to A".
};

/** The number of tolerances by which a separation must differ from zero before a wrong
 sign or scale can be distinguished from chance. At 4, the smallest effect, half the
 separation, is twice the tolerance. [-] */
inline constexpr double kClearOfZero = 4;

/** Returns the answer as it would read if it used one of the conventions known from other
 engines, or two of them at once: the normal from B to A; depth and distance with the
 other sign, halved or doubled; contacts on the surface of A or of B instead of midway.

 It returns only readings that can bring the separation, or the overlap along the normal,
 to the truth, and no reading that leaves the answer unchanged. The simpler ones come
 first. Source: the table of conventions in docs/conventions.md. */
std::vector<Reading> ReadingsOf(const Scenario& scenario, const ContactTruth& truth,
                                const OracleInfo& oracle, const ContactAnswer& answer);

/** Sets the cause of those failures among `findings` that a reading repairs, provided
 that the reading breaks no pass. All findings belong to one answer. */
void ExplainByConvention(const Scenario& scenario, const ContactTruth& truth,
                         const OracleInfo& oracle, const ContactAnswer& answer,
                         std::vector<Finding*>& findings);

}  // namespace touchstone
