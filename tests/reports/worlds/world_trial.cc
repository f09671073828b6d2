// Gives the judge of worlds the motions of engines that are wrong in one way, over the
// worlds of the catalogue.
//
//     world_trial [COUNT [SEED [ENGINE]]]
//
// ENGINE (cookbook) gives the right motions; worlds that it does not simulate, or in
// which the judge finds a fault, are left out and counted. Errors have sizes from 1e-4
// to 10.
//
// Prints how many of COUNT wrong motions passed, were undecidable and failed, by kind of
// error and by how much the motion really differs. A small difference may be legal: a
// step is one, too. Returns 1 if a motion passes that is wrong by more than its own size,
// or if a kind of error was never made.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "oracles/oracle_registry.h"
#include "reports/threads/parallel_for.h"
#include "reports/worlds/study/body_steps.h"
#include "reports/worlds/study/every_step.h"
#include "reports/worlds/study/judge_world.h"
#include "scenarios/scenario_file.h"
#include "tests/reports/worlds/altered_motion.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

/** The upper ends of the ranges of deviations that are counted apart. [-] */
constexpr std::array kRanges = {1e-3, 1e-2, 1e-1, 1.0, HUGE_VAL};
constexpr std::array<std::string_view, kRanges.size()> kRangeNames = {
    "to 1e-3", "to 1 %", "to 10 %", "to 100 %", "beyond"};

/** A world, with its right motion. */
struct Question {
  WorldScenario scenario;
  World every_step;
  Trajectory right;
  bool is_usable = false;
};

enum class Outcome { kNotMade, kPassed, kUndecidable, kFailed };

struct Attempt {
  std::size_t alteration = 0;
  std::string scenario;
  double size = 0;
  double deviation = 0;
  Outcome outcome = Outcome::kNotMade;
};

Outcome OutcomeOf(const WorldScenario& scenario, const OracleInfo& oracle,
                  const Trajectory& of_steps) {
  const Trajectory sampled = SampledAs(scenario.world, of_steps);
  const std::vector<Finding> findings = JudgeWorld({.scenario = scenario,
                                                    .oracle = oracle,
                                                    .trajectory = sampled,
                                                    .of_steps = &of_steps});
  const auto has = [&](auto&& is) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const Finding& finding) { return is(finding.verdict); });
  };
  if (has(IsFailure)) return Outcome::kFailed;
  if (has([](Verdict verdict) { return verdict == Verdict::kUndecidable; }))
    return Outcome::kUndecidable;
  return Outcome::kPassed;
}

std::vector<Question> QuestionsFor(const Oracle& oracle) {
  Catalogue catalogue = ReadCatalogue(InSourceTree("scenarios/catalogue"));
  std::vector<Question> questions;
  for (WorldScenario& scenario : catalogue.worlds)
    questions.push_back({std::move(scenario), {}, {}});
  ParallelFor(questions.size(), 0, [&](std::size_t i) {
    Question& question = questions[i];
    if (!IsStudied(question.scenario)) return;
    question.every_step = EveryStep(question.scenario.world);
    question.right = oracle.Simulate(question.every_step);
    question.is_usable =
        IsWhole(question.right) &&
        OutcomeOf(question.scenario, oracle.info(), question.right) == Outcome::kPassed;
  });
  return questions;
}

Attempt Try(const Question& question, const Oracle& oracle, std::size_t alteration,
            std::uint64_t seed) {
  RandomScene random(seed);
  Attempt attempt{.alteration = alteration,
                  .scenario = question.scenario.id,
                  .size = random.Power(-4, 1)};
  const auto altered = MotionAlterations()[alteration].apply(
      {question.every_step, oracle, question.right}, attempt.size, random);
  if (!altered) return attempt;
  attempt.deviation = DeviationBetween(question.every_step, question.right, *altered);
  if (attempt.deviation == 0) return attempt;
  attempt.outcome = OutcomeOf(question.scenario, oracle.info(), *altered);
  return attempt;
}

/** How often the judge said what. */
struct Tally {
  std::size_t passed = 0;
  std::size_t undecidable = 0;
  std::size_t all = 0;

  void Add(Outcome outcome) {
    passed += outcome == Outcome::kPassed ? 1 : 0;
    undecidable += outcome == Outcome::kUndecidable ? 1 : 0;
    all += outcome == Outcome::kNotMade ? 0 : 1;
  }
  std::string InWords() const {
    if (all == 0) return "";
    return undecidable == 0 ? fmt::format("{} of {}", passed, all)
                            : fmt::format("{} + {} of {}", passed, undecidable, all);
  }
};

int Main(std::size_t count, std::uint64_t seed, std::string_view engine) {
  const OracleRegistry registry = OracleRegistry::BuiltIn();
  const Oracle* oracle = registry.Find(engine);
  if (!oracle || !oracle->info().simulates) {
    fmt::print(stderr, "world_trial: {} simulates no worlds; expected an engine\n",
               engine);
    return 2;
  }
  std::vector<Question> questions = QuestionsFor(*oracle);
  const std::size_t all = questions.size();
  std::erase_if(questions, [](const Question& question) { return !question.is_usable; });
  fmt::print("{} of the {} worlds of the catalogue are right by {}\n\n", questions.size(),
             all, engine);

  const std::size_t kinds = MotionAlterations().size();
  std::vector<Attempt> attempts(count);
  ParallelFor(count, 0, [&](std::size_t n) {
    // Every kind of error meets every world.
    attempts[n] = Try(questions[n / kinds % questions.size()], *oracle, n % kinds,
                      seed * 1000003 + n);
  });

  std::vector<std::array<Tally, kRanges.size()>> tallies(kinds + 1);
  for (const Attempt& attempt : attempts) {
    const auto range = static_cast<std::size_t>(
        std::lower_bound(kRanges.begin(), kRanges.end(), attempt.deviation) -
        kRanges.begin());
    tallies[attempt.alteration][range].Add(attempt.outcome);
    tallies[kinds][range].Add(attempt.outcome);
  }
  fmt::print("{:26}", "passed + undecidable of");
  for (const std::string_view name : kRangeNames) fmt::print("{:>18}", name);
  fmt::print("\n");
  bool is_right = true;
  for (std::size_t k = 0; k <= kinds; ++k) {
    fmt::print("{:26}", k < kinds ? MotionAlterations()[k].name : "all");
    std::size_t made = 0;
    for (const Tally& tally : tallies[k]) {
      fmt::print("{:>18}", tally.InWords());
      made += tally.all;
    }
    fmt::print("\n");
    is_right = is_right && made > 0;
  }
  constexpr double kNeverLegal = 0.01;  // [-]
  for (const Attempt& attempt : attempts)
    is_right = is_right && !(attempt.outcome == Outcome::kPassed &&
                             MotionAlterations()[attempt.alteration].is_never_legal &&
                             attempt.deviation > kNeverLegal);
  fmt::print("\nthe largest that passed:\n");
  std::erase_if(attempts, [](const Attempt& attempt) {
    return attempt.outcome != Outcome::kPassed;
  });
  std::stable_sort(
      attempts.begin(), attempts.end(),
      [](const Attempt& a, const Attempt& b) { return a.deviation > b.deviation; });
  for (std::size_t i = 0; i < std::min<std::size_t>(attempts.size(), 20); ++i)
    fmt::print("  {:8.3g}  {}, {} by {:.3g}\n", attempts[i].deviation,
               attempts[i].scenario, MotionAlterations()[attempts[i].alteration].name,
               attempts[i].size);
  return is_right ? 0 : 1;
}

}  // namespace
}  // namespace touchstone

int main(int argc, char** argv) {
  const auto number = [&](int index, std::uint64_t otherwise) {
    return argc > index ? std::strtoull(argv[index], nullptr, 10) : otherwise;
  };
  return touchstone::Main(number(1, 2000), number(2, 1), argc > 3 ? argv[3] : "cookbook");
}
