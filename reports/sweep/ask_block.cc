#include "reports/sweep/ask_block.h"

namespace touchstone {

SeriesTally AskBlock(const SweepPlan& plan, const SweepBlock& block) {
  if (const auto* worlds = std::get_if<WorldSeries>(&block.questions))
    return AskWorlds(plan, *worlds);
  std::optional<std::size_t> examined;
  if (block.number >= kExaminedBlocks) examined = kExaminedPerKind;
  if (const auto* file = std::get_if<FileSeries>(&block.questions))
    return AskContacts(plan, *file, examined);
  return AskContacts(plan, std::get<QuestionSeries>(block.questions), examined);
}

}  // namespace touchstone
