#include "reports/reproduce/reproduction.h"

#include <limits>
#include <sstream>
#include <string>
#include <vector>

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

TEST_F(ReproductionTest, NamesTheMeasuresThatItCanCheckInsteadOfAnother) {
  finding_.measure = MeasureKind::kSwap;
  try {
    Reproduce(result_, oracle_, finding_);
    ADD_FAILURE() << "expected CannotCheck";
  } catch (const CannotCheck& error) {
    EXPECT_THAT(error.what(), HasSubstr("swap"));
    EXPECT_THAT(error.what(), HasSubstr("contact_surface_error"));
    // The command line's words.
    EXPECT_THAT(error.what(), Not(HasSubstr("--")));
  }
}

TEST_F(ReproductionTest, CountsNoAnswerThatDecidesOtherwise) {
  ContactAnswer& answer = result_.answers.emplace_back();
  answer.touching = true;
  for (const MeasureKind measure :
       {MeasureKind::kExcess, MeasureKind::kContactTooDeep,
        MeasureKind::kContactSurfaceError, MeasureKind::kMixedNormals}) {
    finding_.measure = measure;
    EXPECT_THAT(Reproduce(result_, oracle_, finding_).program,
                HasSubstr("const bool applies = answer.touching;"))
        << NameOf(measure);
  }
  // A separation can be checked whatever the engine decides, if there is one.
  finding_.measure = MeasureKind::kSeparationError;
  EXPECT_THAT(Reproduce(result_, oracle_, finding_).program,
              HasSubstr("const bool applies = !std::isnan(answer.separation);"));
}

// Without any, the program would have zeros for them.
TEST_F(ReproductionTest, CountsNoAnswerWithoutNearestPoints) {
  ContactAnswer& answer = result_.answers.emplace_back();
  answer.separation = 0.5;
  answer.witnesses = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()};
  for (const MeasureKind measure :
       {MeasureKind::kDualityGap, MeasureKind::kWitnessError}) {
    finding_.measure = measure;
    EXPECT_THAT(
        Reproduce(result_, oracle_, finding_).program,
        HasSubstr("const bool applies = !answer.touching && answer.a != answer.b;"))
        << NameOf(measure);
  }
}

TEST_F(ReproductionTest, RefusesTheSurfaceOfAFlatHull) {
  finding_.measure = MeasureKind::kContactSurfaceError;
  result_.answers.emplace_back().touching = true;
  result_.scenario.contact.A.shape = ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

TEST_F(ReproductionTest, RefusesTheReachOfAHalfSpace) {
  result_.scenario.contact.B.shape = HalfSpace{};
  EXPECT_NO_THROW(Reproduce(result_, oracle_, finding_));
  finding_.measure = MeasureKind::kExcess;
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

// A cube of half side 1/8 on a larger one, 2^-10 m deep, and an engine that has returned
// contacts at its lower corners.
class PatchReproductionTest : public ReproductionTest {
 protected:
  PatchReproductionTest() {
    ContactQuery& query = result_.scenario.contact;
    query.A.shape = Box{{0.5, 0.5, 0.5}};
    query.B.shape = Box{{0.125, 0.125, 0.125}};
    query.B.X_WB.p_WB = {0, 0, 0.625 - kDepth};
    result_.truth.separation = {-kDepth, -kDepth};
    ContactAnswer& answer = result_.answers.emplace_back();
    answer.touching = true;
    answer.separation = -kDepth;
    answer.n_AB_W = Eigen::Vector3d::UnitZ();
    for (const double x : {-0.125, 0.125}) {
      for (const double y : {-0.125, 0.125})
        answer.points.push_back({{x, y, 0.5 - kDepth / 2}, -kDepth, {}});
    }
    oracle_.unit_roundoff = 0x1p-53;
  }

  static constexpr double kDepth = 0x1p-10;  // [m]

  std::vector<ContactPoint>& contacts() { return result_.answers.front().points; }
};

TEST_F(PatchReproductionTest, KnowsAPointThatTheContactsLeaveOut) {
  finding_.measure = MeasureKind::kPatchCoverage;
  finding_.value = 0.5;
  contacts().pop_back();
  const std::string program = Reproduce(result_, oracle_, finding_).program;
  EXPECT_THAT(program, HasSubstr("p = {0.1250000"));
  EXPECT_THAT(program, HasSubstr(", 0.49951171875};"));
  EXPECT_THAT(program, HasSubstr("n = {0.0, 0.0, 1.0};"));
  EXPECT_THAT(program, HasSubstr("s = -0.0009765625;"));
}

TEST_F(PatchReproductionTest, RefusesAPatchThatIsCovered) {
  for (const MeasureKind measure :
       {MeasureKind::kPatchCoverage, MeasureKind::kContactCount,
        MeasureKind::kContactOffPatch}) {
    finding_.measure = measure;
    finding_.value = 1;
    EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce)
        << NameOf(measure);
  }
}

TEST_F(PatchReproductionTest, CountsRepeatedContactsOfACoveredPatch) {
  finding_.measure = MeasureKind::kContactCount;
  finding_.value = 1;
  contacts().push_back(contacts().front());
  const std::string program = Reproduce(result_, oracle_, finding_).program;
  EXPECT_THAT(program, HasSubstr("const double error = repeated;"));
  EXPECT_THAT(program, Not(HasSubstr("unspanned")));
}

TEST_F(PatchReproductionTest, KnowsTheSideThatAContactIsBeyond) {
  finding_.measure = MeasureKind::kContactOffPatch;
  contacts().push_back({{0.25, 0, 0.5}, -kDepth, {}});
  const std::string program = Reproduce(result_, oracle_, finding_).program;
  EXPECT_THAT(program, HasSubstr("d = {1.0, 0.0, 0.0};"));
  // The patch is widened by what a rounding of the depth moves a deepest point.
  EXPECT_THAT(program, HasSubstr("q = {0.1250000"));
}

TEST_F(PatchReproductionTest, RefusesAnAnswerWithoutANormal) {
  finding_.measure = MeasureKind::kContactOffPatch;
  result_.answers.front().n_AB_W.reset();
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

TEST_F(PatchReproductionTest, CreatesAHullOfOdeAroundItsOrigin) {
  oracle_.name = "ode";
  oracle_.library = "ODE";
  Body& hull = result_.scenario.contact.B;
  hull.X_WB.p_WB.setZero();
  hull.shape = ConvexHull{{{1, 0, 0}, {3, 0, 0}, {1, 2, 0}, {1, 0, 2}}};
  finding_.measure = MeasureKind::kSeparationError;
  // The mean of the corners, since the origin of the frame is outside.
  EXPECT_THAT(Reproduce(result_, oracle_, finding_).program,
              HasSubstr("dGeomSetPosition(B, 1.5, 0.5, 0.5);"));
  hull.shape = ConvexHull{{{1, 0, 0}, {3, 0, 0}, {1, 2, 0}}};
  EXPECT_THROW(Reproduce(result_, oracle_, finding_), CannotReproduce);
}

}  // namespace
}  // namespace touchstone
