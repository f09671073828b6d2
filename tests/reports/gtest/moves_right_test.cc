#include "reports/gtest/moves_right.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <unistd.h>

#include "docs/examples/my_world.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path kWorlds = InSourceTree("docs/examples/worlds");

/** The example engine with gravity that is `factor` times as strong. */
std::unique_ptr<Oracle> WithGravity(double factor) {
  class Heavy final : public Simulation {
   public:
    Heavy(const World& world, double more) : world_(world), engine_(world_) {
      world_.gravity_W *= more;
    }
    void Push(int, const Eigen::Vector3d&, const Eigen::Vector3d&) override {}
    void Step() override { engine_.Step(); }
    void Read(WorldState& state) const override { engine_.Read(state); }

   private:
    World world_;
    MyWorld engine_;
  };
  return MakeSimulator(
      "mine",
      [factor](const World& world) { return std::make_unique<Heavy>(world, factor); },
      MyWorldSimulates());
}

TEST(MovesRight, PassesTheExampleEngine) {
  EXPECT_TRUE(MovesRight(*WithGravity(1), kWorlds));
}

TEST(MovesRight, ShowsAWrongMotionWithItsProofAndItsFile) {
  const testing::AssertionResult result = MovesRight(*WithGravity(1.01), kWorlds);
  EXPECT_FALSE(result);
  EXPECT_THAT(result.message(),
              AllOf(HasSubstr("mine is wrong in 1 of 1 world:\n  bouncing_ball\n"),
                    HasSubstr("Wrong: mine"), HasSubstr("[[claims]]")));
}

class MovesRightInFolder : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /** Writes the example's world with `from` replaced by `to`, and returns its path. */
  std::filesystem::path Changed(const std::string& from, const std::string& to) const {
    std::ifstream in(InSourceTree("docs/examples/worlds/bouncing_ball.toml"));
    std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    std::ofstream(folder_ / "bouncing_ball.toml") << text.replace(at, from.size(), to);
    return folder_ / "bouncing_ball.toml";
  }

  const std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                        ("moves_right_test_" + std::to_string(getpid()));
};

TEST_F(MovesRightInFolder, RefusesAWorldThatTheSubjectDoesNotSimulate) {
  const auto file = Changed("\nfriction = 0\n", "\nfriction = 0.5\n");
  EXPECT_THAT(MovesRight(*WithGravity(1), file).message(),
              HasSubstr("nothing of mine was verified in 1 world"));
}

TEST_F(MovesRightInFolder, ReportsAClaimThatDoesNotFitItsWorld) {
  const auto file = Changed("bounce_series", "rolls");
  EXPECT_THAT(MovesRight(*WithGravity(1), file).message(),
              HasSubstr("bouncing_ball.toml:"));
}

TEST_F(MovesRightInFolder, ReportsTheErrorsOfAFile) {
  const auto file = Changed("radius = 0.1", "radius = -0.1");
  EXPECT_THAT(MovesRight(*WithGravity(1), file).message(),
              HasSubstr("bouncing_ball.toml:"));
}

TEST_F(MovesRightInFolder, RefusesAPlaceWithoutWorlds) {
  EXPECT_FALSE(MovesRight(*WithGravity(1), folder_));
  EXPECT_FALSE(MovesRight(*WithGravity(1), folder_ / "absent"));
}

}  // namespace
}  // namespace touchstone
