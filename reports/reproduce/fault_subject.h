#pragma once

#include "oracles/oracle.h"
#include "reports/contacts/contact_result.h"
#include "reports/finding/finding.h"

namespace touchstone {

/** A fault of an answer to a contact query, with everything that its check is made of. */
struct FaultSubject {
  const Finding& finding;
  const Scenario& scenario;
  const ContactTruth& truth;
  const ContactAnswer& answer;
  const OracleInfo& oracle;
};

}  // namespace touchstone
