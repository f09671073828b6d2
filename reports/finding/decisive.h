#pragma once

#include <span>

#include "reports/finding/finding.h"

namespace touchstone {

/** Returns the value of `finding` as a multiple of its tolerance, InTolerances(). [-] */
double RelativeToTolerance(const Finding& finding);

/** Returns the finding with the most severe verdict among those of one answer. If there
 are several, one that has a size, unlike CountsContacts(); of those one of the gravest
 grade or reason; and of those the simplest to check, whose measure comes first in the
 enumeration. Null without findings. It does not depend on causes. */
const Finding* DecisiveOf(std::span<const Finding> of_one_answer);

}  // namespace touchstone
