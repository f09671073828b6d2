#include "reports/reproduce/reproduction.h"

#include <limits>
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

TEST_F(ReproductionTest, WaitsForAnEngineThatGivesNoAnswer) {
  finding_.measure = MeasureKind::kAnswering;
  for (const Verdict verdict : {Verdict::kCrashed, Verdict::kTimedOut}) {
    finding_.verdict = verdict;
    finding_.proof = "bullet: killed by SIGSEGV.";
    const Reproduction files = Reproduce(result_, oracle_, finding_);
    EXPECT_THAT(files.program, HasSubstr("fork()"));
    EXPECT_THAT(files.program, HasSubstr("// Proof: bullet: killed by SIGSEGV."));
    EXPECT_THAT(files.report, Not(HasSubstr("The error is")));
  }
}

TEST_F(ReproductionTest, RefusesAVariantWithoutAnAnswer) {
  finding_.measure = MeasureKind::kSwap;
  finding_.verdict = Verdict::kCrashed;
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

TEST_F(ReproductionTest, ChecksTheNumbersOfAnInvalidAnswer) {
  finding_.measure = MeasureKind::kAnswering;
  finding_.verdict = Verdict::kInvalid;
  ContactAnswer& answer = result_.answers.emplace_back();
  answer.separation = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Reproduce(result_, oracle_, finding_).program,
              HasSubstr("std::isfinite(answer.separation)"));
  answer.separation = -0.1;
  answer.n_AB_W = Eigen::Vector3d(0, 0, 2);
  EXPECT_THAT(Reproduce(result_, oracle_, finding_).program,
              HasSubstr("length of the normal"));
  answer.n_AB_W = Eigen::Vector3d::UnitZ();
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

TEST_F(ReproductionTest, GivesTheWholePose) {
  Pose& pose = result_.scenario.contact.A.X_WB;
  pose = Pose::FromQuaternion({1, 2, 3}, Eigen::Quaterniond(0, 0, 1, 0));
  EXPECT_THAT(
      Reproduce(result_, oracle_, finding_).report,
      HasSubstr("at (1, 2, 3), turned by the quaternion (w, x, y, z) = (0, 0, 1, 0)"));
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
