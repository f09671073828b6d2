#include "scenarios/schema/nearest_name.h"

#include <array>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"radius", "half_length",
                                                    "half_height", "position"};

TEST(NearestName, FindsTypingErrorsOfEachKind) {
  EXPECT_EQ(NearestName("raduis", kNames), "radius");            // swapped
  EXPECT_EQ(NearestName("radus", kNames), "radius");             // left out
  EXPECT_EQ(NearestName("raddius", kNames), "radius");           // put in
  EXPECT_EQ(NearestName("half-height", kNames), "half_height");  // replaced
}

TEST(NearestName, TakesTheNearerOfTwoNames) {
  // Five edits from half_length, one from half_height.
  EXPECT_EQ(NearestName("half_heighth", kNames), "half_height");
}

TEST(NearestName, DoesNotGuessIfMoreThanAThirdDiffers) {
  EXPECT_EQ(NearestName("mass", kNames), "");
  EXPECT_EQ(NearestName("pos", kNames), "");
  EXPECT_EQ(NearestName("", kNames), "");
}

}  // namespace
}  // namespace touchstone
