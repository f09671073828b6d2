#pragma once

#include <cstddef>
#include <optional>

#include "reports/sweep/sweep_plan.h"
#include "reports/sweep/tally.h"
#include "reports/threads/stop.h"

namespace touchstone {

/** Asks the subjects of `plan` the questions of one block and judges their answers, each
 subject by itself, without a ledger. A pure function of its arguments; thread safe. Empty
 if it was stopped: a part of a block is no result. */
std::optional<SeriesTally> AskBlock(const SweepPlan& plan, const SweepBlock& block,
                                    const Stop& stop = nullptr);

/** The same for generated contact questions. The certified truth of a question is
 computed once for all subjects. The references of the plan answer too.

 @param examined Same as RunOptions::examined_per_kind, for each subject. */
std::optional<SeriesTally> AskContacts(const SweepPlan& plan, const QuestionSeries& block,
                                       std::optional<std::size_t> examined,
                                       const Stop& stop);

/** The same for contact questions from a file. @pre block.questions. */
std::optional<SeriesTally> AskContacts(const SweepPlan& plan, const FileSeries& block,
                                       std::optional<std::size_t> examined,
                                       const Stop& stop);

/** The same for worlds, by JudgeOnce(). References have no part in the judgement of a
 motion. */
std::optional<SeriesTally> AskWorlds(const SweepPlan& plan, const WorldSeries& block,
                                     const Stop& stop);

}  // namespace touchstone
