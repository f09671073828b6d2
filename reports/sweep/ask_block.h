#pragma once

#include "reports/sweep/sweep_plan.h"
#include "reports/sweep/tally.h"

namespace touchstone {

/** Asks the subjects of `plan` the questions of one block and judges their answers, each
 subject by itself, without a ledger. The certified truth of a question is computed once
 for all subjects. A pure function of its arguments; thread safe. */
SeriesTally AskBlock(const SweepPlan& plan, const QuestionSeries& block);

}  // namespace touchstone
