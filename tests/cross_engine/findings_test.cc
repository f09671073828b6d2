// The engines are still wrong where docs/findings.md says so. If an engine is repaired,
// its test here fails, and the entry goes.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <regex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"
#include "reports/run.h"
#include "reports/worlds/study/run_worlds.h"
#include "scenarios/scenario_file.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using testing::IsEmpty;

const Catalogue& TheFindings() {
  static const Catalogue findings = ReadCatalogue(InSourceTree("docs/findings"));
  return findings;
}

const OracleRegistry& TheOracles() {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry;
}

// Returns those of `measures` that do not prove the oracle wrong in the scenario.
std::vector<std::string> NotFoundBy(const std::vector<MeasureKind>& measures,
                                    const Oracle* oracle, const Scenario& scenario) {
  const RunReport report =
      Run(std::span(&scenario, 1), std::span(&oracle, 1), Ledger{}, RunOptions{});
  std::vector<std::string> missed;
  for (const MeasureKind measure : measures) {
    if (std::none_of(
            report.findings.begin(), report.findings.end(), [&](const Finding& finding) {
              return finding.measure == measure && finding.verdict == Verdict::kFail;
            })) {
      missed.emplace_back(NameOf(measure));
    }
  }
  return missed;
}

// One engine's fault in one file.
struct Accusation {
  const Scenario* scenario;
  const Indictment* indictment;
};

void PrintTo(const Accusation& accusation, std::ostream* out) {
  *out << accusation.scenario->id << " by " << accusation.indictment->oracle;
}

std::vector<Accusation> TheAccusations() {
  std::vector<Accusation> accusations;
  for (const Scenario& scenario : TheFindings().scenarios) {
    for (const Indictment& indictment : scenario.indicts) {
      accusations.push_back({&scenario, &indictment});
    }
  }
  return accusations;
}

class Findings : public testing::TestWithParam<Accusation> {};

TEST_P(Findings, AreFoundAgain) {
  const auto& [scenario, indictment] = GetParam();
  const Oracle* oracle = TheOracles().Find(indictment->oracle);
  ASSERT_TRUE(TheOracles().MayExist(indictment->oracle)) << indictment->oracle;
  if (oracle == nullptr) GTEST_SKIP() << indictment->oracle << " is not in this build";
  EXPECT_THAT(NotFoundBy(indictment->measures, oracle, *scenario), IsEmpty())
      << "See it: touchstone explain docs/" << scenario->id << ".toml";
}

INSTANTIATE_TEST_SUITE_P(OfEngines, Findings, testing::ValuesIn(TheAccusations()),
                         [](const testing::TestParamInfo<Accusation>& instance) {
                           std::string name = instance.param.scenario->id + "_by_" +
                                              instance.param.indictment->oracle;
                           name.erase(0, name.find('/') + 1);
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

TEST(FindingsInWorlds, AreFoundAgain) {
  ASSERT_FALSE(TheFindings().worlds.empty());
  for (const WorldScenario& world : TheFindings().worlds) {
    EXPECT_FALSE(world.indicts.empty()) << world.id;
    for (const Indictment& indictment : world.indicts) {
      EXPECT_TRUE(indictment.reproduces) << world.id;
      const Oracle* oracle = TheOracles().Find(indictment.oracle);
      ASSERT_TRUE(TheOracles().MayExist(indictment.oracle)) << indictment.oracle;
      if (oracle == nullptr) GTEST_SKIP() << indictment.oracle << " is not in this build";
      const std::vector<Finding> findings =
          RunWorlds(std::span(&world, 1), std::span(&oracle, 1), {.jobs = 1}).findings;
      for (const MeasureKind measure : indictment.measures) {
        EXPECT_TRUE(std::ranges::any_of(findings,
                                        [&](const Finding& finding) {
                                          return finding.measure == measure &&
                                                 finding.verdict == Verdict::kFail;
                                        }))
            << NameOf(measure) << ", see touchstone explain docs/" << world.id << ".toml";
      }
    }
  }
}

TEST(FilesOfFindings, HaveNoErrorsAndAccuseAnEngineThatIsWrongToday) {
  EXPECT_THAT(TheFindings().diagnostics, IsEmpty());
  EXPECT_THAT(TheFindings().notes, IsEmpty());
  EXPECT_GE(TheFindings().scenarios.size(), 10U);
  for (const Scenario& scenario : TheFindings().scenarios) {
    EXPECT_FALSE(scenario.indicts.empty()) << scenario.id;
    for (const Indictment& indictment : scenario.indicts) {
      EXPECT_TRUE(indictment.reproduces) << scenario.id;
    }
  }
}

TEST(FilesOfFindings, ShareNoIdWithTheCatalogue) {
  const std::vector<std::filesystem::path> folders = {
      InSourceTree("docs/findings"), InSourceTree("scenarios/catalogue")};
  EXPECT_THAT(ReadCatalogue(folders).diagnostics, IsEmpty());
}

TEST(FilesOfFindings, AreThoseOfTheDocument) {
  std::ifstream file(InSourceTree("docs/findings.md"));
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const std::regex name("docs/(findings/[a-z_]+)\\.toml");
  std::set<std::string> named;
  for (std::sregex_iterator match(text.begin(), text.end(), name), end; match != end;
       ++match) {
    named.insert((*match)[1]);
  }
  std::set<std::string> ids;
  for (const Scenario& scenario : TheFindings().scenarios) ids.insert(scenario.id);
  for (const WorldScenario& world : TheFindings().worlds) ids.insert(world.id);
  EXPECT_EQ(named, ids);
}

TEST(AnEngineThatIsRight, IsNotFound) {
  const Oracle* cookbook = TheOracles().Find("cookbook");
  const auto& scenarios = TheFindings().scenarios;
  const auto cubes =
      std::find_if(scenarios.begin(), scenarios.end(), [](const Scenario& scenario) {
        return scenario.id == "findings/ode_cubes_sharing_an_axis";
      });
  ASSERT_NE(cubes, scenarios.end());
  EXPECT_THAT(NotFoundBy({MeasureKind::kTouching}, cookbook, *cubes),
              testing::ElementsAre("touching"));
}

}  // namespace
}  // namespace touchstone
