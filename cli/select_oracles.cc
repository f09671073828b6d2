#include "cli/select_oracles.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "cli/did_you_mean.h"
#include "cli/input_error.h"

namespace touchstone {
namespace {

bool IsSpecimen(std::string_view name) {
  return name.starts_with("printed");
}

[[noreturn]] void FailOnOracle(const OracleRegistry& registry, std::string_view name) {
  for (const MissingOracle& missing : registry.missing()) {
    if (name == missing.name || missing.name.starts_with(fmt::format("{}/", name))) {
      throw InputError(fmt::format("the oracle '{}' is not in this build: {}", name,
                                   missing.how_to_get));
    }
  }
  std::vector<std::string> names;
  if (IsSpecimen(name)) {
    names = registry.SpecimenNames();
  } else {
    for (const Oracle* oracle : registry.All()) names.push_back(oracle->info().name);
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw InputError(fmt::format("there is no oracle '{}'{}; expected one of: {}{}", name,
                               DidYouMean(name, views), fmt::join(names, ", "),
                               IsSpecimen(name) ? ", or errata joined by +" : ""));
}

}  // namespace

std::vector<const Oracle*> OraclesNamed(const OracleRegistry& registry,
                                        const std::string& pattern) {
  std::vector<const Oracle*> oracles = registry.Matching(pattern);
  if (oracles.empty()) {
    const Oracle* specimen = registry.Find(pattern);
    if (specimen == nullptr) FailOnOracle(registry, pattern);
    oracles.push_back(specimen);
  }
  return oracles;
}

std::vector<const Oracle*> SubjectsNamed(const OracleRegistry& registry,
                                         const std::string& list, QuestionKind kind) {
  std::vector<const Oracle*> subjects;
  const auto add = [&subjects](const Oracle* oracle) {
    if (std::find(subjects.begin(), subjects.end(), oracle) == subjects.end())
      subjects.push_back(oracle);
  };
  std::istringstream names(list);
  for (std::string name; std::getline(names, name, ',');) {
    if (name != "all") {
      if (const Oracle* exact = registry.Find(name)) {
        add(exact);
      } else {
        for (const Oracle* oracle : OraclesNamed(registry, name)) add(oracle);
      }
      continue;
    }
    for (const Oracle* oracle : registry.All()) {
      const OracleInfo& info = oracle->info();
      const bool answers =
          kind == QuestionKind::kWorld ? info.simulates : info.AnswersContacts();
      if (!IsSpecimen(info.name) && answers) add(oracle);
    }
  }
  if (subjects.empty()) FailOnOracle(registry, list);
  return subjects;
}

const Oracle& OracleNamed(const OracleRegistry& registry, const std::string& name) {
  const Oracle* oracle = registry.Find(name);
  if (oracle == nullptr) FailOnOracle(registry, name);
  return *oracle;
}

std::vector<const Oracle*> SelectOracles(const OracleRegistry& registry,
                                         const OracleSelection& selection) {
  const Oracle* subject = &OracleNamed(registry, selection.subject);
  std::vector<const Oracle*> oracles = {subject};
  const auto add = [&oracles](const Oracle* oracle) {
    if (std::find(oracles.begin(), oracles.end(), oracle) == oracles.end()) {
      oracles.push_back(oracle);
    }
  };
  if (selection.against.empty()) {
    for (const Oracle* oracle : registry.All()) {
      if (!IsSpecimen(oracle->info().name)) add(oracle);
    }
  }
  for (const std::string& pattern : selection.against) {
    for (const Oracle* oracle : OraclesNamed(registry, pattern)) add(oracle);
  }
  return oracles;
}

}  // namespace touchstone
