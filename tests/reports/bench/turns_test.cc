#include "reports/bench/turns.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/reports/bench/planted_simulator.h"

namespace touchstone {
namespace {

// Uses the CPU for that time.
void Work(double microseconds) {
  timespec time{};
  const auto now = [&] {
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) +
           1e-3 * static_cast<double>(time.tv_nsec);
  };
  const double end = now() + microseconds;
  while (now() < end) {
  }
}

// A step takes 300 µs of CPU time in one thread, else 100 µs.
PlantedSimulator Worker(const std::string& name) {
  return PlantedSimulator(name, [](int threads, int) { Work(threads == 1 ? 300 : 100); });
}

TEST(TimeInTurns, HasTheMedianOfTheCpuTimesOfTheTurns) {
  const PlantedSimulator slow = Worker("slow");
  const PlantedSimulator idle("idle", [](int, int) { usleep(100); });
  const std::vector<const Oracle*> oracles = {&slow, &idle};
  const std::vector<TimedSteps> rows =
      TimeInTurns(oracles, TwoBalls(), {.steps = 30, .seconds = 60, .threads = 1});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].Name(), "slow");
  EXPECT_EQ(rows[0].turns.size(), 15u);
  EXPECT_NEAR(rows[0].Microseconds(), 300, 30);
  EXPECT_LT(rows[1].Microseconds(), 100);
  EXPECT_GT(RatioOf(rows[0], rows[1]), 3);
  EXPECT_EQ(RatioOf(rows[0], rows[0]), 1);
}

TEST(TimeInTurns, SettlesBeforeTheTimedSteps) {
  const PlantedSimulator oracle("planted");
  const std::vector<const Oracle*> oracles = {&oracle};
  const std::vector<TimedSteps> rows =
      TimeInTurns(oracles, TwoBalls(), {.steps = 7, .seconds = 60, .threads = 1});
  EXPECT_EQ(rows[0].turns.size(), 7u);  // Fewer steps than turns.
  EXPECT_EQ(rows[0].measured->quality.sideways, 14);
}

TEST(TimeInTurns, TimesOneThreadAndSeveralByWallTime) {
  PlantedSimulator several = Worker("several");
  several.info().steps_in_threads = true;
  const PlantedSimulator one = Worker("one");
  const std::vector<const Oracle*> oracles = {&several, &one};
  const std::vector<TimedSteps> rows =
      TimeInTurns(oracles, TwoBalls(), {.steps = 15, .seconds = 60, .threads = 2});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].Name(), "several");
  EXPECT_EQ(rows[1].Name(), "several, 2 threads");
  EXPECT_EQ(rows[2].Name(), "one");
  EXPECT_TRUE(rows[1].turns.empty());
  EXPECT_GE(rows[0].Microseconds(), 300);
  EXPECT_GE(rows[1].Microseconds(), 100);
  EXPECT_LT(rows[1].Microseconds(), rows[0].Microseconds());
  EXPECT_EQ(RatioOf(rows[0], rows[1]), rows[0].Microseconds() / rows[1].Microseconds());
}

TEST(TimeInTurns, LosesOnlyTheResultsOfAnEngineThatDies) {
  const PlantedSimulator dying("dying", [](int, int step) {
    if (step == 20) {
      std::fputs("a NaN\n", stderr);
      std::raise(SIGFPE);
    }
  });
  const PlantedSimulator whole("whole");
  const std::vector<const Oracle*> oracles = {&dying, &whole};
  const std::vector<TimedSteps> rows =
      TimeInTurns(oracles, TwoBalls(), {.steps = 15, .seconds = 60, .threads = 1});
  EXPECT_FALSE(rows[0].measured.has_value());
  EXPECT_EQ(rows[0].Microseconds(), HUGE_VAL);
  EXPECT_EQ(rows[0].reason, "killed by SIGFPE: a NaN");
  EXPECT_EQ(rows[0].complaint, "a NaN");
  ASSERT_TRUE(rows[1].measured.has_value());
  EXPECT_EQ(rows[1].reason, "");
  EXPECT_EQ(rows[1].complaint, "");
}

// Each ratio is of the times of one turn: 1, 10, 1, 1/10 and 1.
TEST(RatioOf, IsTheMedianOfTheRatiosOfTheTurns) {
  TimedSteps a;
  TimedSteps b;
  a.turns = {1, 20, 3, 4, 5};
  b.turns = {1, 2, 3, 40, 5};
  EXPECT_EQ(RatioOf(a, b), 1);
}

}  // namespace
}  // namespace touchstone
