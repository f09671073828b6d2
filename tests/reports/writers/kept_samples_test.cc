#include "reports/writers/data/kept_samples.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace touchstone {
namespace {

using testing::ElementsAre;

std::vector<double> Tenths(std::size_t count) {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) times.push_back(0.1 * static_cast<double>(i));
  return times;
}

TEST(KeptSamples, AreEveryNthAndTheFirstStepAndTheEnd) {
  EXPECT_THAT(KeptSamples(Tenths(9), 4, {}, {}), ElementsAre(0, 1, 4, 8));
  EXPECT_THAT(KeptSamples(Tenths(10), 4, {}, {}), ElementsAre(0, 1, 4, 8, 9));
  EXPECT_THAT(KeptSamples(Tenths(2), 4, {}, {}), ElementsAre(0, 1));
  EXPECT_THAT(KeptSamples(Tenths(4), 1, {}, {}), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(KeptSamples(Tenths(1), 4, {}, {}), ElementsAre(0));
  EXPECT_THAT(KeptSamples({}, 4, {}, {}), ElementsAre());
}

// A body that passes through a wall between two samples is seen on either side of it.
TEST(KeptSamples, AreOnBothSidesOfAMoment) {
  EXPECT_THAT(KeptSamples(Tenths(20), 8, {1.25, 0, 1.25}, {}),
              ElementsAre(0, 1, 8, 12, 13, 16, 19));
  EXPECT_THAT(KeptSamples(Tenths(20), 8, {0.75, 7}, {}), ElementsAre(0, 1, 7, 8, 16, 19));
}

// A motion that diverges has fewer samples, and its last one is what it diverged to.
TEST(KeptSamples, HaveTheLastOfEveryMotion) {
  const std::vector<std::size_t> lengths = {10, 7, 0, 3};
  EXPECT_THAT(KeptSamples(Tenths(10), 4, {}, lengths), ElementsAre(0, 1, 2, 4, 6, 8, 9));
}

TEST(KeptSamples, AreFewHoweverManyMomentsThereAre) {
  std::vector<double> moments = Tenths(1000);
  EXPECT_LE(KeptSamples(Tenths(1000), 100, moments, {}).size(), 10U + 2 + 2 * 8);
}

}  // namespace
}  // namespace touchstone
