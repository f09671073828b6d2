// The catalogue as tests, named CrossEngine/<oracle>.<scenario>: one per scenario
// (contact query or world) and oracle that answers such scenarios. All tests of an oracle
// share one run. Known discrepancies pass, as they do for `touchstone run`.
//
// CTest has one entry per oracle, which runs all scenarios on that oracle alone, for
// `ctest -R fcl`. They have the label each_engine, and scripts/test leaves them out.
// --write-ctest FILE writes the entries.
#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cli/select_oracles.h"
#include "reports/ledger/ledger_file.h"
#include "reports/run.h"
#include "reports/writers/outcome.h"
#include "scenarios/scenario_file.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

// Replaces all characters except letters and digits by underscores: ':', '*', '?' and '-'
// have a meaning in GoogleTest filters.
std::string TestName(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; },
      '_');
  return name;
}

// The shared data of the tests: the questions, the oracles and, once a test needs them,
// the findings.
class Suite {
 public:
  static Suite& Instance() {
    static Suite suite;
    return suite;
  }

  const Questions& questions() const { return questions_; }
  const std::vector<const Oracle*>& oracles() const { return oracles_; }

  // The results of one oracle on all questions, for one CTest entry.
  struct Part {
    RunReport report;
    std::vector<Outcome> outcomes;  // Indexed by question.
  };
  const Part& Of(std::size_t oracle) {
    Part& part = parts_[oracle];
    if (part.outcomes.empty()) {
      part.report = Run(questions_, std::span(oracles_).subspan(oracle, 1),
                        ledger_.ledger.value_or(Ledger{}), {});
      part.outcomes = OutcomesOf(part.report);
    }
    return part;
  }

 private:
  Suite() : Suite(ReadCatalogue(InSourceTree("scenarios/catalogue"))) {}

  explicit Suite(Catalogue catalogue)
      : questions_{std::move(catalogue.scenarios), std::move(catalogue.worlds)},
        ledger_(ReadLedgerFile(InSourceTree("scenarios/known_discrepancies.toml"))),
        registry_(OracleRegistry::BuiltIn()),
        oracles_(SelectOracles(
            registry_, {.subject = "cookbook", .tolerance = {}, .against = {}})) {}

  Questions questions_;
  LedgerResult ledger_;
  OracleRegistry registry_;
  std::vector<const Oracle*> oracles_;
  std::map<std::size_t, Part> parts_;
};

std::string FailuresOf(const RunReport& report, const Outcome& outcome) {
  const std::string& id = IdOf(report, outcome.scenario);
  std::string text = id + ": " + TitleOf(report, outcome.scenario) + "\n";
  for (const Finding& finding : outcome.findings) {
    if (IsFailure(finding.verdict)) text += Sentence(finding) + "\n";
  }
  return text + "See it: touchstone explain " + id;
}

class ScenarioTest : public testing::Test {
 public:
  ScenarioTest(std::size_t question, std::size_t oracle)
      : question_(question), oracle_(oracle) {}

  void TestBody() override {
    const Suite::Part& part = Suite::Instance().Of(oracle_);
    const Outcome& outcome = part.outcomes[question_];
    if (outcome.verdict == Verdict::kUnsupported) {
      GTEST_SKIP() << (outcome.decisive == nullptr ? "no measure applies"
                                                   : outcome.decisive->proof);
    }
    if (IsFailure(outcome.verdict)) ADD_FAILURE() << FailuresOf(part.report, outcome);
  }

 private:
  std::size_t question_;
  std::size_t oracle_;
};

std::string SuiteName(const OracleInfo& info) {
  return "CrossEngine/" + TestName(info.name);
}

void RegisterTests() {
  Suite& suite = Suite::Instance();
  for (std::size_t o = 0; o < suite.oracles().size(); ++o) {
    const OracleInfo& info = suite.oracles()[o]->info();
    std::size_t question = 0;
    const auto add = [&](const std::string& id, bool answers) {
      const std::size_t q = question++;
      if (!answers) return;
      testing::RegisterTest(
          SuiteName(info).c_str(), TestName(id).c_str(), nullptr, nullptr, __FILE__,
          __LINE__, [q, o]() -> testing::Test* { return new ScenarioTest(q, o); });
    };
    for (const Scenario& scenario : suite.questions().contacts)
      add(scenario.id, info.AnswersContacts());
    for (const WorldScenario& world : suite.questions().worlds)
      add(world.id, info.simulates);
  }
}

void WriteCTest(const std::string& program, const char* file) {
  std::ofstream out(file);
  const auto add = [&](const std::string& name, const std::string& suite) {
    out << "add_test([=[cross_engine." << name << "]=] [=[" << program
        << "]=] [=[--gtest_filter=" << suite << ".*]=] --gtest_brief=1)\n";
  };
  for (const Oracle* oracle : Suite::Instance().oracles()) {
    const std::string& name = oracle->info().name;
    add(name, SuiteName(oracle->info()));
    out << "set_tests_properties([=[cross_engine." << name
        << "]=] PROPERTIES LABELS each_engine)\n";
  }
}

}  // namespace
}  // namespace touchstone

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc == 3 && std::string_view(argv[1]) == "--write-ctest") {
    touchstone::WriteCTest(argv[0], argv[2]);
    return 0;
  }
  touchstone::RegisterTests();
  return RUN_ALL_TESTS();
}
