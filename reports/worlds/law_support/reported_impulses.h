#pragma once

#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {

/** The reported contact impulses on each body from one sample to the next. */
struct ReportedImpulses {
  /** Indexed by body; each contact appears under both of its bodies. */
  std::vector<std::vector<const ContactImpulse*>> on_body;
  /** Number of contacts in a step of this interval, on average, at least 1. */
  double contacts_per_step = 1;
};

/** Returns the impulses of the steps after sample `s` − 1 up to sample `s`. */
ReportedImpulses ReportedBefore(const Motion& motion, std::size_t s);

/** Returns the faults of a claim that the impulses on bodies account for their motion: an
 engine reports those of contacts, not those of springs and joints. */
std::vector<Fault> FaultsOfReported(const World& world, const Claim& claim);

}  // namespace touchstone
