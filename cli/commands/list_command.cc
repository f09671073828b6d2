#include "cli/commands/list_command.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <string>

#include <fmt/format.h>

#include "reports/writers/outcome.h"

namespace touchstone {

int ListCommand(const ScenarioSelection& selection) {
  const Questions questions = SelectQuestions(selection);
  std::vector<std::pair<std::string, std::string>> titles;
  for (const Scenario& scenario : questions.contacts)
    titles.emplace_back(scenario.id, scenario.title);
  for (const WorldScenario& scenario : questions.worlds)
    titles.emplace_back(scenario.id, scenario.title);
  std::size_t width = 0;
  for (const auto& [id, title] : titles) width = std::max(width, id.size());
  std::map<std::string, int> groups;
  for (const auto& [id, title] : titles) {
    std::cout << fmt::format("{:<{}}  {}\n", id, width, title);
    ++groups[std::string(GroupOf(id))];
  }
  std::cout << '\n';
  for (const auto& [group, count] : groups) {
    std::cout << fmt::format("{:>6}  {}\n", count, group);
  }
  std::cout << fmt::format("{:>6}  scenario{}\n", titles.size(),
                           titles.size() == 1 ? "" : "s");
  return 0;
}

}  // namespace touchstone
