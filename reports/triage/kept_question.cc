#include "reports/triage/kept_question.h"

#include "scenarios/scenario_file.h"

namespace touchstone {

Question QuestionOf(const FailedQuestion& failure) {
  ReadResult read = ReadScenario(failure.scenario, "a kept failure");
  if (read.world) return std::move(*read.world);
  return std::move(read.scenario.value());
}

std::pair<int, Size> PlainnessOf(const Question& question) {
  const Size size = SizeOf(question);
  return {size.decades, size};
}

}  // namespace touchstone
