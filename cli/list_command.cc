#include "cli/list_command.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <string>

#include <fmt/format.h>

#include "reports/writers/outcome.h"

namespace touchstone {

int ListCommand(const ScenarioSelection& selection) {
  const std::vector<Scenario> scenarios = SelectScenarios(selection);
  std::size_t width = 0;
  for (const Scenario& scenario : scenarios) width = std::max(width, scenario.id.size());
  std::map<std::string, int> groups;
  for (const Scenario& scenario : scenarios) {
    std::cout << fmt::format("{:<{}}  {}\n", scenario.id, width, scenario.title);
    ++groups[std::string(GroupOf(scenario.id))];
  }
  std::cout << '\n';
  for (const auto& [group, count] : groups) {
    std::cout << fmt::format("{:>6}  {}\n", count, group);
  }
  std::cout << fmt::format("{:>6}  scenario{}\n", scenarios.size(),
                           scenarios.size() == 1 ? "" : "s");
  return 0;
}

}  // namespace touchstone
