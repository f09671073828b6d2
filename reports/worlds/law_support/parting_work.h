#pragma once

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {

/** Returns the most energy that an engine may add to the subjects when it moves apart
 bodies that overlap at the start. [J]

 Moving apart two bodies may lift each of them by the depth, and all that moves with them:
 the bodies that overlap them, rest on them or are held by a rod. In such a cluster each
 body is lifted by the sum of the depths at most, so Σ d · Σ |m g + F| of each cluster is
 granted. A body rests on a cluster if the cluster's depths close the gap, and if the
 normal of the gap is not level: pushing along it then lifts one of the two. */
double WorkOfParting(const Motion& motion, const Subjects& subjects);

}  // namespace touchstone
