// Tests that neither an engine nor a program that changes the floating-point arithmetic
// of the process changes a verdict.

#include "tests/oracles/foreign_arithmetic.h"

#include <array>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "oracles/standard_arithmetic.h"
#include "reports/run.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

std::vector<Scenario> Scenarios() {
  std::vector<Scenario> scenarios;
  for (const Specimen& s :
       {SphereInBoxFace(1e-3), BoxOnBoxFace(1e-3), BoxOnBoxFace(-1e-3),
        SphereInHalfSpace(1e-3), BoxOnBoxFace(-1e-16)}) {
    Scenario& scenario = scenarios.emplace_back();
    scenario.id = "contact/foreign/" + std::to_string(scenarios.size());
    scenario.contact = s.query;
  }
  return scenarios;
}

/** Returns all findings of an oracle on one thread, as text with every digit. */
std::string Judged(const FakeOracle& oracle, const std::vector<Scenario>& scenarios) {
  RunOptions options;
  options.jobs = 1;
  const std::array<const Oracle*, 1> oracles{&oracle};
  const RunReport report = Run(scenarios, oracles, {}, options);
  std::string text;
  for (const Finding& f : report.findings) {
    text += fmt::format("{} {} {} {:a} {:a} {}\n", f.scenario, NameOf(f.measure),
                        NameOf(f.verdict), f.value, f.tolerance, f.proof);
  }
  return text;
}

TEST(ForeignArithmetic, OfAnEngineChangesNoVerdict) {
  const std::vector<Scenario> scenarios = Scenarios();
  const std::string calm = Judged(FakeOracle("mine"), scenarios);
  EXPECT_NE(calm.find("pass"), std::string::npos);
  const FakeOracle foreign("mine", [](const ContactQuery& query) {
    ContactAnswer answer;
    {
      const StandardArithmetic arithmetic;
      answer = RightAnswer(query);
    }
    SetForeignArithmetic();
    return answer;
  });
  EXPECT_EQ(Judged(foreign, scenarios), calm);
  EXPECT_TRUE(IsArithmeticStandard());
}

TEST(ForeignArithmetic, OfTheProgramChangesNoVerdict) {
  const std::vector<Scenario> scenarios = Scenarios();
  const std::string calm = Judged(FakeOracle("mine"), scenarios);
  std::string in_foreign;
  std::jthread([&] {
    SetForeignArithmetic();
    in_foreign = Judged(FakeOracle("mine"), scenarios);
  }).join();
  EXPECT_EQ(in_foreign, calm);
}

}  // namespace
}  // namespace touchstone
