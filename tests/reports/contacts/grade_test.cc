#include "reports/contacts/grade.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

/** Returns the grade of an error of `size` times the diagonal of the smaller box. */
Grade GradeOfLength(double size) {
  const Specimen s = BoxOnBoxFace(2e-3);
  const double extent = 2 * Eigen::Vector3d(0.06, 0.05, 0.11).norm();
  Finding finding;
  finding.measure = MeasureKind::kSeparationError;
  finding.value = size * extent;
  return GradeOf(finding, s.query, s.truth);
}

TEST(Grade, OfALengthIsRelativeToTheSmallerBody) {
  EXPECT_EQ(GradeOfLength(0.9e-6), Grade::kRounding);
  EXPECT_EQ(GradeOfLength(1.1e-6), Grade::kSmall);
  EXPECT_EQ(GradeOfLength(1.1e-3), Grade::kLarge);
  EXPECT_EQ(GradeOfLength(0.11), Grade::kGross);
  EXPECT_EQ(GradeOfLength(NAN), Grade::kGross);
}

TEST(Grade, OfAWrongTouchDependsOnTheDistanceFromTouching) {
  Finding finding;
  finding.measure = MeasureKind::kTouching;
  finding.value = 1;
  for (const auto& [depth, grade] :
       {std::pair(2e-3, Grade::kWrongTouch), std::pair(-2e-3, Grade::kWrongTouch),
        std::pair(1e-9, Grade::kRounding)}) {
    const Specimen s = BoxOnBoxFace(depth);
    EXPECT_EQ(GradeOf(finding, s.query, s.truth), grade);
  }
}

TEST(Grade, OfAnInvalidAnswerIsThatOfItsNormalIfThatIsAll) {
  EXPECT_EQ(GradeOf({.what = "n is short", .off_unit = 1e-14}), Grade::kRounding);
  EXPECT_EQ(GradeOf({.what = "n is short", .off_unit = 0.01}), Grade::kLarge);
  EXPECT_EQ(GradeOf({.what = "NaN", .off_unit = {}}), Grade::kUnusable);
}

}  // namespace
}  // namespace touchstone
