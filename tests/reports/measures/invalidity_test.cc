#include "reports/measures/invalidity.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kUnitSlack = 16 * 0x1p-53;

ContactAnswer Touching() {
  return BoxOnBoxFace(2e-3).right;
}

TEST(Invalidity, IsNotFoundInRightAnswers) {
  EXPECT_EQ(InvalidityOf(Touching(), kUnitSlack), std::nullopt);
  EXPECT_EQ(InvalidityOf(SphereInBoxFace(-2e-3).right, kUnitSlack), std::nullopt);
}

TEST(Invalidity, NamesEachFieldThatIsNotANumber) {
  const double nan = std::nan("");
  ContactAnswer answer = Touching();
  answer.separation = nan;
  EXPECT_EQ(InvalidityOf(answer, kUnitSlack), "separation is nan");
  answer = Touching();
  answer.n_AB_W->y() = nan;
  EXPECT_EQ(InvalidityOf(answer, kUnitSlack), "n_AB_W is not finite");
  answer = Touching();
  answer.points[2].p_WC.z() = INFINITY;
  EXPECT_EQ(InvalidityOf(answer, kUnitSlack), "points[2].p_WC is not finite");
  answer = Touching();
  answer.points[1].separation = nan;
  EXPECT_EQ(InvalidityOf(answer, kUnitSlack), "points[1].separation is not finite");
  answer = SphereInBoxFace(-2e-3).right;
  answer.witnesses->p_WCb.x() = nan;
  EXPECT_EQ(InvalidityOf(answer, kUnitSlack), "a witness point is not finite");
}

TEST(Invalidity, SeesANormalThatIsNotUnit) {
  ContactAnswer answer = Touching();
  *answer.n_AB_W *= 1 + 1e-14;
  EXPECT_NE(InvalidityOf(answer, kUnitSlack), std::nullopt);
  answer.n_AB_W->setZero();
  EXPECT_EQ(InvalidityOf(answer, kUnitSlack),
            "n_AB_W has length 0, not 1 to within 1.8e-15");
}

TEST(Invalidity, SeesAContactWithoutANormal) {
  ContactAnswer answer = Touching();
  answer.n_AB_W.reset();
  EXPECT_EQ(InvalidityOf(answer, kUnitSlack), "points[0] has no normal");
}

}  // namespace
}  // namespace touchstone
