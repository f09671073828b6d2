#pragma once

#include <utility>

#include "reports/shrink/question.h"
#include "reports/shrink/size.h"
#include "reports/sweep/tally.h"

namespace touchstone {

/** Returns the question of a failure. @pre It can be read. */
Question QuestionOf(const FailedQuestion& failure);

/** Returns how plain a question is, the plainest first: one whose sizes and distances are
 0.1 m to 10 m before all others, then the one that has less to read. */
std::pair<int, Size> PlainnessOf(const Question& question);

}  // namespace touchstone
