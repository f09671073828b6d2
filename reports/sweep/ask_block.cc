#include "reports/sweep/ask_block.h"

namespace touchstone {

std::optional<SeriesTally> AskBlock(const SweepPlan& plan, const SweepBlock& block,
                                    const Stop& stop) {
  if (const auto* worlds = std::get_if<WorldSeries>(&block.questions))
    return AskWorlds(plan, *worlds, stop);
  std::optional<std::size_t> examined;
  if (block.number >= kExaminedBlocks) examined = kExaminedPerKind;
  if (const auto* file = std::get_if<FileSeries>(&block.questions))
    return AskContacts(plan, *file, examined, stop);
  return AskContacts(plan, std::get<QuestionSeries>(block.questions), examined, stop);
}

}  // namespace touchstone
