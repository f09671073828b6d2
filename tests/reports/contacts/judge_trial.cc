// Gives the judge right answers to hard questions, each altered in one field. Half of
// them are those of a double engine, half those of a float engine.
//
//     judge_trial [COUNT [SEED [WIDER]]]
//
// The alterations are sized by the question and the arithmetic alone. WIDER gives the
// judge tolerances that are wider by so many times the roundings: the trial must notice.
//
// Asks until COUNT answers were made wrong and COUNT were altered legally, each counted
// by kind. Returns 1 if the judge passes a wrong answer or fails a right one, or if a
// kind of alteration was never made.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "oracles/stated_tolerance.h"
#include "reports/contacts/judge_answer.h"
#include "reports/referee/referee.h"
#include "reports/threads/parallel_for.h"
#include "tests/reports/contacts/altered_answer.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/referee/hard_question.h"

namespace touchstone {
namespace {

/** What the judge says of one alteration. */
enum class Outcome { kNotMade, kPassed, kUndecidable, kFailed };

struct Judged {
  std::vector<Outcome> wrong;
  std::vector<Outcome> legal;
  std::string complaint;  ///< The first wrong verdict; empty if there is none.
};

OracleInfo PromisesEverything(double unit_roundoff, double wider) {
  FakeOracle oracle("mine");
  oracle.info().unit_roundoff = unit_roundoff;
  if (wider > 0) {
    SetTolerance({.length = 0, .share = wider * 64 * unit_roundoff, .by = "the trial"},
                 oracle.info());
  }
  oracle.ForEachPair(
      [](Capability& capability) { capability.penetrating_witnesses = true; });
  return oracle.info();
}

Judged Judge(std::uint64_t seed, std::uint64_t index, double wider) {
  static const OracleInfo in_double = PromisesEverything(0x1p-53, wider);
  static const OracleInfo in_float = PromisesEverything(0x1p-24, wider);
  // Each arithmetic meets every pair of shapes, family and hardening.
  const OracleInfo& oracle = (index / 48 + index / 432) % 2 == 0 ? in_double : in_float;
  Judged judged{std::vector(WrongAlterations().size(), Outcome::kNotMade),
                std::vector(LegalAlterations().size(), Outcome::kNotMade),
                {}};
  Scenario scenario;
  scenario.id = fmt::format("trial/{}/{}", seed, index);
  scenario.contact = HardQuestionAt(seed, index).query;
  const ContactTruth truth = ComputeContactTruth(scenario.contact);
  const Accuracy accuracy = AccuracyOf(scenario.contact, truth, oracle.unit_roundoff);
  const auto right = RightAnswerOf(scenario.contact, truth, accuracy);
  if (!right) return judged;
  const RightlyAnswered question{scenario.contact, truth, accuracy, *right,
                                 oracle.unit_roundoff};
  RandomScene random(seed * 1000003 + index);

  const auto judge = [&](const Alteration& alteration, bool is_wrong) {
    const auto altered = alteration.apply(question, random);
    if (!altered) return Outcome::kNotMade;
    const std::vector<Finding> findings = JudgeAnswer(scenario, truth, oracle, *altered);
    const auto failure =
        std::find_if(findings.begin(), findings.end(),
                     [](const Finding& finding) { return IsFailure(finding.verdict); });
    if (is_wrong == (failure == findings.end()) && judged.complaint.empty()) {
      judged.complaint = fmt::format(
          "question {} of seed {}, {}: {}", index, seed, alteration.name,
          is_wrong ? "passes"
                   : std::string(NameOf(failure->measure)) + ": " + failure->proof +
                         " Allowed: " + failure->tolerance_because);
    }
    if (failure != findings.end()) return Outcome::kFailed;
    const bool passed = std::all_of(
        findings.begin(), findings.end(),
        [](const Finding& finding) { return finding.verdict == Verdict::kPass; });
    return passed ? Outcome::kPassed : Outcome::kUndecidable;
  };
  for (std::size_t k = 0; k < judged.wrong.size(); ++k)
    judged.wrong[k] = judge(WrongAlterations()[k], true);
  for (std::size_t k = 0; k < judged.legal.size(); ++k)
    judged.legal[k] = judge(LegalAlterations()[k], false);
  return judged;
}

/** How often the judge said what of one kind of alteration. */
struct Tally {
  std::size_t passed = 0;
  std::size_t undecidable = 0;
  std::size_t failed = 0;

  std::size_t total() const { return passed + undecidable + failed; }
  void Add(Outcome outcome) {
    passed += outcome == Outcome::kPassed ? 1 : 0;
    undecidable += outcome == Outcome::kUndecidable ? 1 : 0;
    failed += outcome == Outcome::kFailed ? 1 : 0;
  }
};

std::size_t Total(const std::vector<Tally>& tallies) {
  std::size_t total = 0;
  for (const Tally& tally : tallies) total += tally.total();
  return total;
}

/** Prints a table and returns the number of alterations that were judged wrongly or never
 made. */
std::size_t Print(std::string_view title, std::span<const Alteration> alterations,
                  const std::vector<Tally>& tallies, bool are_wrong) {
  std::size_t faults = 0;
  Tally all;
  fmt::print("{:32} {:>9} {:>9} {:>12} {:>9}\n", title, "answers", "passed",
             "undecidable", "failed");
  const auto row = [](std::string_view name, const Tally& t) {
    fmt::print("{:32} {:9} {:9} {:12} {:9}\n", name, t.total(), t.passed, t.undecidable,
               t.failed);
  };
  for (std::size_t k = 0; k < tallies.size(); ++k) {
    const Tally& t = tallies[k];
    row(alterations[k].name, t);
    faults += t.total() == 0 ? 1 : are_wrong ? t.passed + t.undecidable : t.failed;
    all.passed += t.passed;
    all.undecidable += t.undecidable;
    all.failed += t.failed;
  }
  row("all", all);
  fmt::print("\n");
  return faults;
}

int Main(std::uint64_t count, std::uint64_t seed, double wider) {
  std::vector<Tally> wrong(WrongAlterations().size());
  std::vector<Tally> legal(LegalAlterations().size());
  int complaints = 0;
  // Every 11th question of the series, so that a batch of a third of its period meets
  // every pair, family and hardening.
  constexpr std::size_t kBatch = 1008;
  constexpr std::uint64_t kStride = 11;
  for (std::uint64_t first = 0; Total(wrong) < count || Total(legal) < count;
       first += kBatch) {
    std::vector<Judged> all(kBatch);
    ParallelFor(kBatch, 0, [&](std::size_t i) {
      all[i] = Judge(seed, kStride * (first + i), wider);
    });
    for (const Judged& judged : all) {
      for (std::size_t k = 0; k < wrong.size(); ++k) wrong[k].Add(judged.wrong[k]);
      for (std::size_t k = 0; k < legal.size(); ++k) legal[k].Add(judged.legal[k]);
      if (!judged.complaint.empty() && ++complaints <= 20)
        fmt::print("{}\n", judged.complaint);
    }
  }
  const std::size_t faults = Print("made wrong", WrongAlterations(), wrong, true) +
                             Print("altered legally", LegalAlterations(), legal, false);
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace touchstone

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const double wider = argc > 3 ? std::strtod(argv[3], nullptr) : 0;
  return touchstone::Main(count, seed, wider);
}
