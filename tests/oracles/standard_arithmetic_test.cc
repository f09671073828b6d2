#include "oracles/standard_arithmetic.h"

#include <cfenv>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "oracles/function_simulator.h"
#include "tests/oracles/foreign_arithmetic.h"

namespace touchstone {
namespace {

TEST(StandardArithmetic, HoldsWhileItLivesAndEndsWithIt) {
  std::fenv_t before;
  std::fegetenv(&before);
  SetForeignArithmetic();
  {
    const StandardArithmetic arithmetic;
    EXPECT_TRUE(IsArithmeticStandard());
    SetForeignArithmetic();
    EXPECT_FALSE(IsArithmeticStandard());
  }
  const bool is_standard = IsArithmeticStandard();
  std::fesetenv(&before);
  EXPECT_FALSE(is_standard);
}

/** A simulation that changes the arithmetic in every step. */
class Foreign final : public Simulation {
 public:
  explicit Foreign(const World& world) : bodies_(world.bodies.size()) {}
  void Step() override { SetForeignArithmetic(); }
  void Read(WorldState& state) const override { state.bodies.resize(bodies_); }
  void Push(int, const Eigen::Vector3d&, const Eigen::Vector3d&) override {}

 private:
  std::size_t bodies_;
};

TEST(StandardArithmetic, SurvivesASimulationThatChangesIt) {
  const auto oracle = MakeSimulator<Foreign>("foreign", SimulatorPromises{});
  World world;
  world.steps = 2;
  EXPECT_EQ(oracle->Simulate(world).status, AnswerStatus::kAnswered);
  EXPECT_TRUE(IsArithmeticStandard());
}

}  // namespace
}  // namespace touchstone
