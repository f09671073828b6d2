#include "reports/bench/stepping_child.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/reports/bench/planted_simulator.h"

namespace touchstone {
namespace {

// Volatile, so that the compiler cannot remove the endless loop.
volatile int forever = 1;

// Returns the reason of the end of a child whose engine does `deed` in its third step.
std::string ReasonOf(void (*deed)(),
                     std::chrono::seconds wall = std::chrono::minutes(2)) {
  const PlantedSimulator oracle("planted", [&](int, int step) {
    if (step == 3) deed();
  });
  const World world = TwoBalls();
  SteppingChild child(oracle, world, {1, std::chrono::milliseconds(300), wall});
  EXPECT_TRUE(child.Step(2).has_value());
  EXPECT_TRUE(child.Quality().has_value());
  EXPECT_FALSE(child.Step(2).has_value());
  EXPECT_FALSE(child.Step(2).has_value());
  EXPECT_FALSE(child.Quality().has_value());
  return child.Reason();
}

TEST(SteppingChild, StepsOnDemandAndMeasuresTheState) {
  const PlantedSimulator oracle("planted");
  const World world = TwoBalls();
  SteppingChild child(oracle, world, {});
  EXPECT_TRUE(child.Step(2).has_value());
  EXPECT_EQ(child.Quality()->sideways, 2);
  EXPECT_TRUE(child.Step(3).has_value());
  const WorldQuality quality = child.Quality().value();
  EXPECT_EQ(quality.sideways, 5);
  EXPECT_EQ(quality.fastest, 3);
  EXPECT_NEAR(quality.deepest, 0.25, 1e-12);
}

TEST(SteppingChild, ReturnsTheAverageTimeOfAStep) {
  const PlantedSimulator oracle("planted", [](int, int) { usleep(2000); });
  const World world = TwoBalls();
  SteppingChild child(oracle, world, {});
  const StepTime time = child.Step(10).value();
  EXPECT_GT(time.wall, 1990);  // [µs]
  EXPECT_LT(time.cpu, 1000);
}

TEST(SteppingChild, HasAReasonForItsEnd) {
  EXPECT_EQ(ReasonOf([] { std::raise(SIGSEGV); }), "killed by SIGSEGV");
  EXPECT_EQ(ReasonOf([] {
              std::fputs("no more memory\n", stderr);
              std::abort();
            }),
            "aborted: no more memory");
  EXPECT_EQ(ReasonOf([] { throw std::logic_error("a flat simplex"); }),
            "aborted: threw std::logic_error: a flat simplex");
  EXPECT_EQ(ReasonOf([] {
              while (forever != 0) {
              }
            }),
            "no answer after 0.3 s of CPU time");
  EXPECT_EQ(ReasonOf(
                [] {
                  while (forever != 0) pause();
                },
                std::chrono::seconds(2)),
            "no answer after 2 s, blocked");
}

// The limit is for all steps together: a step of a fast engine is short.
TEST(SteppingChild, HasALimitOfCpuTimeForAllSteps) {
  const PlantedSimulator oracle("planted", [](int, int) {
    const auto end = std::clock() + CLOCKS_PER_SEC / 10;
    while (std::clock() < end) {
    }
  });
  const World world = TwoBalls();
  SteppingChild child(oracle, world,
                      {1, std::chrono::milliseconds(550), std::chrono::seconds(20)});
  int steps = 0;
  while (steps < 100 && child.Step(1)) ++steps;
  // A busy machine may add to the 0.1 s of a step, but takes nothing away.
  EXPECT_GE(steps, 1);
  EXPECT_LE(steps, 5);
}

TEST(SteppingChild, KeepsTheLastLineOfAllItsSteps) {
  const PlantedSimulator oracle("planted", [](int, int step) {
    if (step == 1) std::fputs("one\nanother\n", stderr);
  });
  const World world = TwoBalls();
  SteppingChild child(oracle, world, {});
  EXPECT_EQ(child.LastLine(), "");
  child.Step(1);
  child.Step(1);
  EXPECT_EQ(child.LastLine(), "another");
}

}  // namespace
}  // namespace touchstone
