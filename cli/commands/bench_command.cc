#include "cli/commands/bench_command.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/median.h"
#include "cli/commands/sweep_command.h"
#include "reports/text/counted.h"
#include "reports/referee/referee.h"
#include "reports/writers/describe.h"
#include "scenarios/generators/generate.h"

namespace touchstone {
namespace {

struct Accuracy {
  double worst_error = 0;  ///< Largest certain error of the separation. [m]
  int measured = 0;        ///< Answers with a separation.
  int wrong_verdicts = 0;  ///< Touching reported where certainly apart, or the reverse.
  int without_answer = 0;
};

struct Row {
  const Oracle* oracle;
  std::optional<double> nanoseconds;  ///< Per query; empty if the oracle is not timed.
  Accuracy accuracy;
};

// CPU time of this thread: it excludes other work of the machine. [ns]
double ThreadNanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

// Median over several passes for each engine, empty if it is not timed. The engines take
// turns, so that a temporary slowdown of the machine affects all of them alike.
std::vector<std::optional<double>> NanosecondsPerQuery(
    std::span<const Oracle* const> oracles, std::span<const ContactQuery> queries) {
  constexpr int kTurns = 5;
  constexpr int kPasses = 3;  // Per turn.
  std::vector<std::unique_ptr<PreparedBatch>> batches;
  for (const Oracle* oracle : oracles) {
    // Timing runs in this process, so an engine that may hang or abort would end it.
    const bool is_safe = !oracle->info().isolated;
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
        const double start = ThreadNanoseconds();
        batches[i]->Run();
        const double time = ThreadNanoseconds() - start;
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

Accuracy AccuracyOf(const Oracle& oracle, std::span<const ContactQuery> queries,
                    std::span<const ContactTruth> truths) {
  std::vector<ContactAnswer> answers(queries.size());
  oracle.Answer(queries, answers);
  Accuracy accuracy;
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
    const double error = LeastError(*answers[i].separation, truths[i]);
    // Written so that a NaN counts as the worst.
    if (!(error <= accuracy.worst_error)) accuracy.worst_error = error;
    if (std::isnan(accuracy.worst_error)) accuracy.worst_error = HUGE_VAL;
  }
  return accuracy;
}

void Print(std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.nanoseconds.value_or(HUGE_VAL) < b.nanoseconds.value_or(HUGE_VAL);
  });
  for (const Row& row : rows) {
    const std::string time =
        row.nanoseconds ? fmt::format("{:>10.0f}{:>7.1f}×", *row.nanoseconds,
                                      *row.nanoseconds / *rows.front().nanoseconds)
                        : fmt::format("{:>18}", "not timed");
    const Accuracy& accuracy = row.accuracy;
    const std::string error = accuracy.measured == 0
                                  ? "none given"
                                  : fmt::format("{:.2g}", accuracy.worst_error);
    std::cout << fmt::format("  {:<26}{} {:>16}{:>10}{:>15}{:>11}\n",
                             row.oracle->info().name, time, error, accuracy.measured,
                             accuracy.wrong_verdicts, accuracy.without_answer);
  }
}

void BenchPair(ShapeKind A, ShapeKind B, std::span<const Oracle* const> oracles,
               const BenchArguments& arguments) {
  std::vector<ContactQuery> queries;
  for (std::uint64_t i = 0; i < arguments.count; ++i) {
    queries.push_back(Generate(Family::kRandom, A, B, arguments.seed, i));
  }
  const std::span<const ContactQuery> sample = std::span(queries).first(
      static_cast<std::size_t>(std::min(arguments.sample, arguments.count)));
  std::vector<ContactTruth> truths;
  for (const ContactQuery& query : sample) truths.push_back(JudgeContact(query));
  const auto touching = std::count_if(
      truths.begin(), truths.end(),
      [](const auto& truth) { return truth.touching == Touching::kTouching; });

  std::vector<const Oracle*> able;
  std::copy_if(oracles.begin(), oracles.end(), std::back_inserter(able),
               [&](const Oracle* oracle) { return oracle->info().For(A, B).supported; });
  if (able.empty()) return;
  const std::vector<std::optional<double>> nanoseconds =
      NanosecondsPerQuery(able, queries);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < able.size(); ++i)
    rows.push_back({able[i], nanoseconds[i], AccuracyOf(*able[i], sample, truths)});
  std::cout << fmt::format(
      "{} {}: {}, {} checked against the truth, {} of them touching\n"
      "  {:<26}{:>10}{:>8} {:>16}{:>10}{:>15}{:>11}\n",
      NameOf(A), NameOf(B), Counted(queries.size(), "random pose"), sample.size(),
      touching, "oracle", "ns/query", "of best", "worst error [m]", "measured",
      "wrong touching", "no answer");
  const bool all_timed = std::all_of(rows.begin(), rows.end(), [](const Row& row) {
    return row.nanoseconds.has_value();
  });
  Print(std::move(rows));
  if (!all_timed)
    std::cout << "  not timed: the oracle has no bare call to time, or runs in its own "
                 "process because it may hang\n";
  std::cout << '\n';
}

}  // namespace

int BenchCommand(const Session& session, const BenchArguments& arguments) {
  std::vector<const Oracle*> oracles;
  if (arguments.oracles.empty()) oracles = session.registry.All();
  for (const std::string& pattern : arguments.oracles) {
    for (const Oracle* oracle : OraclesNamed(session.registry, pattern)) {
      oracles.push_back(oracle);
    }
  }
  if (!arguments.pair.empty()) {
    const auto [A, B] = PairNamed(arguments.pair);
    BenchPair(A, B, oracles, arguments);
    return 0;
  }
  // The shape pairs that the cookbook engine supports.
  BenchPair(ShapeKind::kSphere, ShapeKind::kSphere, oracles, arguments);
  BenchPair(ShapeKind::kSphere, ShapeKind::kBox, oracles, arguments);
  BenchPair(ShapeKind::kBox, ShapeKind::kBox, oracles, arguments);
  return 0;
}

}  // namespace touchstone
