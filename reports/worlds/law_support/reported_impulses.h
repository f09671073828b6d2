#pragma once

#include <string>
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
  double total = 0;  ///< Sum of the magnitudes of all impulses. [N s]
};

/** Returns the impulses of the steps after sample `s` − 1 up to sample `s`. */
ReportedImpulses ReportedBefore(const Motion& motion, std::size_t s);

/** Returns the faults of a claim that the impulses on bodies account for their motion: an
 engine reports those of contacts, not those of springs and joints. */
std::vector<Fault> FaultsOfReported(const World& world, const Claim& claim);

/** The momentum that a body may lose when it falls asleep. */
struct SleepLoss {
  double momentum = 0;  ///< [N s]
  double angular = 0;   ///< [N m s]
};

/** Returns what body `index` may have lost by falling asleep before sample `s`: with u
 the engine's documented sleep speed, m u and u/R of the largest moment of inertia, if the
 body has no velocity at all at the sample and the contacts of `reported` carry at least
 half of its loads; else nothing. A body that stops in the air under a load is not asleep,
 however great u is. A sleeping body is granted it at every sample, since the impulses
 that are reported of it are those of the step in which it fell asleep.
 @pre `reported` is ReportedBefore(motion, s). */
SleepLoss SleepLossBefore(const Motion& motion, const ReportedImpulses& reported,
                          int index, std::size_t s);

/** Returns `because`, the origin of a tolerance that grants SleepLossBefore() too, with
 the documented sleep speed of `oracle`. Returns it unchanged if no body sleeps. */
std::string WithSleep(std::string because, const OracleInfo& oracle);

}  // namespace touchstone
