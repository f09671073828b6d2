#include "reports/reproduce/reproduction.h"

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/reproduce/engine_code.h"

namespace touchstone {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// Two balls, 0.1 m deep, and the answer of an engine that says something else.
class ReproductionTest : public testing::Test {
 protected:
  ReproductionTest() {
    ContactQuery& query = result_.scenario.contact;
    query.A.shape = Sphere{0.5};
    query.B.shape = Sphere{0.5};
    query.B.X_WB.p_WB.x() = 0.9;
    result_.truth.separation = {-0.1, -0.1};
    oracle_.name = "bullet";
    oracle_.library = "Bullet";
    finding_.measure = MeasureKind::kSeparationError;
    finding_.verdict = Verdict::kFail;
    finding_.tolerance = 1e-9;
  }

  ScenarioResult result_;
  OracleInfo oracle_;
  Finding finding_;
};

TEST_F(ReproductionTest, KeepsTheProofInCommentsAndLiterals) {
  finding_.proof =
      "one */ two\n#error three \"four\"\n??"
      "/ five \\";
  const std::string program = Reproduce(result_, oracle_, finding_).program;
  std::istringstream lines(program);
  std::string line;
  while (std::getline(lines, line) && line.find("#include") != 0) {
    if (line.empty()) continue;
    EXPECT_THAT(line, StartsWith("//"));
  }
  EXPECT_THAT(program, Not(HasSubstr("\n#error")));
  EXPECT_THAT(program, HasSubstr(R"(one */ two #error three \"four\" \?\?/ five \\")"));
}

TEST_F(ReproductionTest, RefusesACrash) {
  finding_.verdict = Verdict::kCrashed;
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

TEST_F(ReproductionTest, RefusesAMeasureWithoutACheck) {
  finding_.measure = MeasureKind::kContactCount;
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

TEST_F(ReproductionTest, RefusesTheReachOfAHalfSpace) {
  result_.scenario.contact.B.shape = HalfSpace{};
  EXPECT_NO_THROW(Reproduce(result_, oracle_, finding_));
  finding_.measure = MeasureKind::kExcess;
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

}  // namespace
}  // namespace touchstone
