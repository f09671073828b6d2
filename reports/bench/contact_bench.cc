#include "reports/bench/contact_bench.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <memory>

#include "reports/bench/median.h"
#include "reports/measures/outside.h"
#include "reports/referee/referee.h"
#include "scenarios/generators/generate.h"

namespace touchstone {
namespace {

// The time by a clock of the system. [ns]
double Nanoseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

// The clock for an oracle. The CPU time of this thread excludes other work of the
// machine, but also what a program does that answers for it.
clockid_t ClockFor(const Oracle& oracle) {
  return oracle.info().external ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID;
}

// Median over several passes for each engine, empty if it is not timed.
std::vector<std::optional<double>> NanosecondsPerQuery(
    std::span<const Oracle* const> oracles, std::span<const ContactQuery> queries) {
  constexpr int kTurns = 5;
  constexpr int kPasses = 3;  // Per turn.
  std::vector<std::unique_ptr<PreparedBatch>> batches;
  for (const Oracle* oracle : oracles) {
    // Timing runs in this process, so an engine that may hang or abort would end it.
    const bool is_safe = !oracle->info().isolated || oracle->info().external;
    batches.push_back(is_safe ? oracle->Prepare(queries) : nullptr);
  }
  std::vector<std::vector<double>> passes(oracles.size());
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t i = 0; i < batches.size(); ++i) {
      if (batches[i] == nullptr) continue;
      // Warm-up: caches and branch predictors still hold the state of the previous
      // engine, and engines allocate in their first pass.
      for (int pass = 0; pass < kPasses; ++pass) batches[i]->Run();
      for (int pass = 0; pass < kPasses; ++pass) {
        const clockid_t clock = ClockFor(*oracles[i]);
        const double start = Nanoseconds(clock);
        batches[i]->Run();
        const double time = Nanoseconds(clock) - start;
        passes[i].push_back(time / static_cast<double>(queries.size()));
      }
    }
  }
  std::vector<std::optional<double>> medians(oracles.size());
  for (std::size_t i = 0; i < batches.size(); ++i) {
    if (batches[i] != nullptr) medians[i] = MedianOf(passes[i]);
  }
  return medians;
}

SampleAccuracy AccuracyOf(const Oracle& oracle, std::span<const ContactQuery> queries,
                          std::span<const ContactTruth> truths) {
  std::vector<ContactAnswer> answers(queries.size());
  oracle.Answer(queries, answers);
  SampleAccuracy accuracy;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].status != AnswerStatus::kAnswered) {
      ++accuracy.without_answer;
      continue;
    }
    const bool wrong = truths[i].touching ==
                       (answers[i].touching ? Touching::kApart : Touching::kTouching);
    if (wrong) ++accuracy.wrong_verdicts;
    if (!answers[i].separation) continue;
    ++accuracy.measured;
    const double error = Outside(*answers[i].separation, truths[i].separation);
    // Written so that a NaN counts as the worst.
    if (!(error <= accuracy.worst_error)) accuracy.worst_error = error;
    if (std::isnan(accuracy.worst_error)) accuracy.worst_error = HUGE_VAL;
  }
  return accuracy;
}

}  // namespace

ContactBench BenchContacts(ShapeKind A, ShapeKind B,
                           std::span<const Oracle* const> oracles,
                           const ContactBenchSettings& settings) {
  std::vector<const Oracle*> able;
  std::copy_if(oracles.begin(), oracles.end(), std::back_inserter(able),
               [&](const Oracle* oracle) { return oracle->info().For(A, B).supported; });
  if (able.empty()) return {};
  std::vector<ContactQuery> queries;
  for (std::uint64_t i = 0; i < settings.count; ++i)
    queries.push_back(Generate(Family::kRandom, A, B, settings.seed, i));
  const std::span<const ContactQuery> sample = std::span(queries).first(
      static_cast<std::size_t>(std::min(settings.sample, settings.count)));
  std::vector<ContactTruth> truths;
  for (const ContactQuery& query : sample) truths.push_back(ComputeContactTruth(query));
  ContactBench bench{queries.size(), sample.size(), 0, {}};
  for (const ContactTruth& truth : truths)
    bench.touching += truth.touching == Touching::kTouching ? 1 : 0;
  const std::vector<std::optional<double>> nanoseconds =
      NanosecondsPerQuery(able, queries);
  for (std::size_t i = 0; i < able.size(); ++i)
    bench.rows.push_back({able[i], nanoseconds[i], AccuracyOf(*able[i], sample, truths)});
  return bench;
}

}  // namespace touchstone
