#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/check_claims.h"
#include "tests/catalogue/the_catalogue.h"

namespace touchstone {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

TEST(Worlds, AreIdentifiedAsWorlds) {
  EXPECT_FALSE(TheCatalogue().worlds.empty());
  for (const WorldScenario& world : TheCatalogue().worlds)
    EXPECT_THAT(world.id, StartsWith("world/"));
}

TEST(Worlds, StateTheSourceOfTheirNumbers) {
  // A derivation or a citation cannot be shorter than this.
  constexpr std::size_t kShortestSource = 40;
  for (const WorldScenario& world : TheCatalogue().worlds) {
    EXPECT_GE(world.source.size(), kShortestSource) << world.id;
    EXPECT_THAT(world.source, EndsWith(".")) << world.id;
    EXPECT_NE(world.source, world.title) << world.id;
  }
}

TEST(Worlds, HaveOnlyValidClaims) {
  for (const WorldScenario& scenario : TheCatalogue().worlds) {
    EXPECT_FALSE(scenario.claims.empty()) << scenario.id;
    for (const Diagnostic& error : ErrorsOfClaims(scenario))
      ADD_FAILURE() << ToString(error);
  }
}

}  // namespace
}  // namespace touchstone
