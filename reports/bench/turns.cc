#include "reports/bench/turns.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "reports/bench/median.h"
#include "reports/bench/stepping_child.h"

namespace touchstone {
namespace {

constexpr int kTurns = 15;

struct Runner {
  TimedSteps result;
  std::unique_ptr<SteppingChild> child;
  std::vector<StepTime> turns;
};

// An engine that waits without working is stopped after a minute per second of CPU time,
// which is long enough to use that time on a machine shared with many other processes.
Stepping SteppingOf(int threads, int seconds) {
  return {threads, std::chrono::seconds(seconds) * threads,
          std::chrono::minutes(seconds)};
}

// An oracle that steps in several threads has two runners: one thread, then several.
std::vector<Runner> Start(std::span<const Oracle* const> oracles, const World& world,
                          const TurnSettings& settings) {
  std::vector<Runner> runners;
  const auto start = [&](const Oracle& oracle, int threads) {
    Runner& runner = runners.emplace_back();
    runner.result.oracle = oracle.info().name;
    runner.result.threads = threads;
    runner.child = std::make_unique<SteppingChild>(oracle, world,
                                                   SteppingOf(threads, settings.seconds));
  };
  for (const Oracle* oracle : oracles) {
    start(*oracle, 1);
    if (settings.threads > 1 && oracle->info().steps_in_threads)
      start(*oracle, settings.threads);
  }
  return runners;
}

void TakeTurns(std::vector<Runner>& runners, int steps) {
  for (Runner& runner : runners) runner.child->Step(steps);
  const auto until = [&](long turn) { return static_cast<int>(steps * turn / kTurns); };
  for (int turn = 0; turn < kTurns; ++turn) {
    const int now = until(turn + 1) - until(turn);
    if (now == 0) continue;
    for (Runner& runner : runners) {
      const std::optional<StepTime> time = runner.child->Step(now);
      if (time) runner.turns.push_back(*time);
    }
  }
}

std::vector<double> CpuOf(const std::vector<StepTime>& turns) {
  std::vector<double> times;
  times.reserve(turns.size());
  for (const StepTime& turn : turns) times.push_back(turn.cpu);
  return times;
}

// Other processes can only add to wall time, so the best turn is the least disturbed.
MeasuredSteps BestByWall(const std::vector<StepTime>& turns, int threads) {
  const StepTime& best = *std::min_element(
      turns.begin(), turns.end(),
      [](const StepTime& a, const StepTime& b) { return a.wall < b.wall; });
  return {best.wall, best.waited / (threads * best.wall), {}};
}

TimedSteps ResultOf(Runner runner, bool by_wall) {
  TimedSteps& result = runner.result;
  const std::optional<WorldQuality> quality = runner.child->Quality();
  if (!quality) {
    result.reason = runner.child->Reason();
  } else if (by_wall) {
    result.measured = BestByWall(runner.turns, result.threads);
  } else {
    // The median ignores turns that were disturbed.
    result.turns = CpuOf(runner.turns);
    result.measured = MeasuredSteps{MedianOf(result.turns), 0, {}};
  }
  if (quality) result.measured->quality = *quality;
  result.complaint = runner.child->LastLine();
  return std::move(result);
}

}  // namespace

std::string TimedSteps::Name() const {
  return threads == 1 ? oracle : fmt::format("{}, {} threads", oracle, threads);
}

double TimedSteps::Microseconds() const {
  return measured ? measured->microseconds : HUGE_VAL;
}

std::vector<TimedSteps> TimeInTurns(std::span<const Oracle* const> oracles,
                                    const World& world, const TurnSettings& settings) {
  std::vector<Runner> runners = Start(oracles, world, settings);
  TakeTurns(runners, settings.steps);
  std::vector<TimedSteps> results;
  for (Runner& runner : runners)
    results.push_back(ResultOf(std::move(runner), settings.threads > 1));
  return results;
}

double RatioOf(const TimedSteps& a, const TimedSteps& b) {
  if (a.turns.empty()) return a.Microseconds() / b.Microseconds();
  std::vector<double> ratios;
  ratios.reserve(a.turns.size());
  for (std::size_t turn = 0; turn < a.turns.size(); ++turn)
    ratios.push_back(a.turns[turn] / b.turns[turn]);
  return MedianOf(ratios);
}

}  // namespace touchstone
