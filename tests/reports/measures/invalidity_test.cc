#include "reports/measures/invalidity.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kUnitSlack = 16 * 0x1p-53;

/** Returns the reason in words; empty if the answer is valid. */
std::string ReasonOf(const ContactAnswer& answer) {
  const auto fault = InvalidityOf(answer, kUnitSlack);
  return fault ? fault->what : "";
}

ContactAnswer Touching() {
  return BoxOnBoxFace(2e-3).right;
}

TEST(Invalidity, IsNotFoundInRightAnswers) {
  EXPECT_EQ(ReasonOf(Touching()), "");
  EXPECT_EQ(ReasonOf(SphereInBoxFace(-2e-3).right), "");
}

TEST(Invalidity, NamesEachFieldThatIsNotANumber) {
  const double nan = std::nan("");
  ContactAnswer answer = Touching();
  answer.separation = nan;
  EXPECT_EQ(ReasonOf(answer), "separation is nan");
  answer = Touching();
  answer.n_AB_W->y() = nan;
  EXPECT_EQ(ReasonOf(answer), "n_AB_W is not finite");
  answer = Touching();
  answer.points[2].p_WC.z() = INFINITY;
  EXPECT_EQ(ReasonOf(answer), "points[2].p_WC is not finite");
  answer = Touching();
  answer.points[1].separation = nan;
  EXPECT_EQ(ReasonOf(answer), "points[1].separation is not finite");
  answer = SphereInBoxFace(-2e-3).right;
  answer.witnesses->p_WCb.x() = nan;
  EXPECT_EQ(ReasonOf(answer), "a witness point is not finite");
}

TEST(Invalidity, SeesANormalThatIsNotUnit) {
  ContactAnswer answer = Touching();
  *answer.n_AB_W *= 1 + 1e-14;
  EXPECT_NEAR(InvalidityOf(answer, kUnitSlack).value().off_unit.value(), 1e-14, 1e-15);
  answer.n_AB_W->setZero();
  EXPECT_FALSE(InvalidityOf(answer, kUnitSlack).value().off_unit);  // No direction.
  EXPECT_EQ(ReasonOf(answer), "n_AB_W has length 0, not 1 to within 1.8e-15");
}

// A normal that is short by a rounding must not make a NaN look harmless.
TEST(Invalidity, IsTheGravestOfSeveral) {
  ContactAnswer answer = Touching();
  *answer.n_AB_W *= 1 + 1e-14;
  answer.points[1].separation = std::nan("");
  EXPECT_EQ(ReasonOf(answer), "points[1].separation is not finite");
  answer = Touching();
  *answer.n_AB_W *= 1 + 1e-14;
  answer.points[0].n_AB_W = 1.01 * *answer.n_AB_W;
  EXPECT_NEAR(InvalidityOf(answer, kUnitSlack).value().off_unit.value(), 0.01, 1e-10);
  answer.points[1].n_AB_W = Eigen::Vector3d::Zero();
  EXPECT_FALSE(InvalidityOf(answer, kUnitSlack).value().off_unit);
  answer = SphereInBoxFace(-2e-3).right;
  if (answer.n_AB_W) *answer.n_AB_W *= 1 + 1e-14;
  answer.witnesses->p_WCb.x() = INFINITY;
  EXPECT_EQ(ReasonOf(answer), "a witness point is not finite");
}

TEST(Invalidity, SeesAContactWithoutANormal) {
  ContactAnswer answer = Touching();
  answer.n_AB_W.reset();
  EXPECT_EQ(ReasonOf(answer), "points[0] has no normal");
}

}  // namespace
}  // namespace touchstone
