#include "reports/adapter_check/check_contacts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "oracles/isolation/answer_wire.h"
#include "reports/adapter_check/contact_mistakes.h"
#include "reports/contacts/judge_answer.h"
#include "reports/referee/referee.h"
#include "scenarios/generators/generate.h"

namespace touchstone {
namespace {

// Questions of a pair. A mistake of an adapter shows in nearly all of them; two of three
// questions about random bodies touch.
constexpr std::uint64_t kQuestions = 24;
constexpr std::uint64_t kSeed = 20261128;

// The part of the wrong answers that a mistake may leave wrong, because the engine has
// faults of its own.
constexpr double kLeftOver = 0.1;

// A mistake is named on the evidence of so many wrong answers, which it makes right, and
// of so large a part of the answers that it concerns: one or two may be chance.
constexpr std::ptrdiff_t kLeastEvidence = 4;
constexpr std::ptrdiff_t kLeastShare = 4;  // A quarter.

/** A question, its certified truth, and the answer to it. */
struct Asked {
  Scenario scenario;
  ContactTruth truth;
  ContactAnswer answer;
};

/** How an answer is judged. */
enum class Judged { kRight, kUndecidable, kUnsupported, kInexact, kWrong };

// Returns the first finding that proves the answer wrong, and not only inexact.
std::optional<Finding> FaultOf(const std::vector<Finding>& findings) {
  const auto found = std::ranges::find_if(findings, [](const Finding& finding) {
    return finding.verdict == Verdict::kInvalid ||
           (IsProvedWrong(finding) && finding.grade >= Grade::kLarge);
  });
  return found == findings.end() ? std::nullopt : std::optional(*found);
}

Judged Judge(const Scenario& scenario, const ContactTruth& truth,
             const OracleInfo& oracle, const ContactAnswer& answer) {
  if (answer.status == AnswerStatus::kUnsupported) return Judged::kUnsupported;
  if (answer.status != AnswerStatus::kAnswered) return Judged::kWrong;
  const std::vector<Finding> findings =
      JudgeAnswer(scenario, truth, oracle, answer, Reasons::kNone);
  if (FaultOf(findings)) return Judged::kWrong;
  if (std::ranges::any_of(findings, IsProvedWrong)) return Judged::kInexact;
  const bool is_decided =
      !findings.empty() && std::ranges::all_of(findings, [](const Finding& finding) {
        return finding.verdict == Verdict::kPass;
      });
  return is_decided ? Judged::kRight : Judged::kUndecidable;
}

Scenario ScenarioOf(const ContactQuery& query) {
  Scenario scenario;
  scenario.contact = query;
  return scenario;
}

// Judges an answer as if the adapter had made `mistakes`. Nothing if they do not change
// what is judged.
std::optional<Judged> JudgeWith(std::span<const ContactMistake* const> mistakes,
                                const OracleInfo& oracle, const Asked& asked) {
  ContactQuery query = asked.scenario.contact;
  ContactAnswer answer = asked.answer;
  bool is_other_question = false;
  bool is_other_answer = false;
  for (const ContactMistake* mistake : mistakes) {
    if (mistake->asked) {
      if (const auto other = mistake->asked(query)) {
        query = *other;
        is_other_question = true;
      }
    } else if (const auto meant = mistake->meant(asked.scenario.contact, answer)) {
      answer = *meant;
      is_other_answer = true;
    }
  }
  if (!is_other_question && !is_other_answer) return std::nullopt;
  if (!is_other_question) return Judge(asked.scenario, asked.truth, oracle, answer);
  return Judge(ScenarioOf(query), ComputeContactTruth(query), oracle, answer);
}

// Returns whether `mistakes` make nearly all wrong answers right, and no right one wrong.
bool Explain(std::span<const ContactMistake* const> mistakes, const OracleInfo& oracle,
             std::span<const Asked> all, std::span<const Judged> judged) {
  const auto wrong = std::ranges::count(judged, Judged::kWrong);
  const auto allowed =
      static_cast<std::ptrdiff_t>(kLeftOver * static_cast<double>(wrong));
  std::ptrdiff_t left = 0;
  std::ptrdiff_t concerned = 0;
  std::ptrdiff_t repaired = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (judged[i] == Judged::kUnsupported) continue;
    std::optional<Judged> now;
    if (all[i].answer.status == AnswerStatus::kAnswered)
      now = JudgeWith(mistakes, oracle, all[i]);
    if (now) ++concerned;
    const bool is_wrong = now.value_or(judged[i]) == Judged::kWrong;
    if (is_wrong && judged[i] != Judged::kWrong) return false;
    if (is_wrong && ++left > allowed) return false;
    const bool is_right = now == Judged::kRight || now == Judged::kInexact;
    if (judged[i] == Judged::kWrong && is_right) ++repaired;
  }
  return repaired >= kLeastEvidence && kLeastShare * repaired >= concerned;
}

std::vector<std::string> MistakesThatExplain(const OracleInfo& oracle,
                                             std::span<const Asked> all,
                                             std::span<const Judged> judged) {
  std::vector<std::string> sentences;
  const std::vector<ContactMistake>& known = ContactMistakes();
  for (const ContactMistake& mistake : known) {
    const ContactMistake* const one[] = {&mistake};
    if (Explain(one, oracle, all, judged)) sentences.push_back(mistake.sentence);
  }
  if (!sentences.empty()) return sentences;
  for (std::size_t i = 0; i < known.size(); ++i) {
    for (std::size_t j = i + 1; j < known.size(); ++j) {
      const ContactMistake* const two[] = {&known[i], &known[j]};
      if (Explain(two, oracle, all, judged)) {
        sentences.push_back(
            fmt::format("{}, and {}", known[i].sentence, known[j].sentence));
      }
    }
  }
  // Of many pairs that would do, none is known to be it.
  constexpr std::size_t kMost = 2;
  if (sentences.size() > kMost) sentences.clear();
  return sentences;
}

std::string ExampleOf(const OracleInfo& oracle, const Asked& asked) {
  if (asked.answer.status != AnswerStatus::kAnswered) return asked.answer.reason;
  const std::optional<Finding> fault =
      FaultOf(JudgeAnswer(asked.scenario, asked.truth, oracle, asked.answer));
  return fault ? fault->proof : "";
}

PairCheck CheckPair(const Oracle& oracle, ShapeKind A, ShapeKind B) {
  std::vector<ContactQuery> queries;
  for (std::uint64_t i = 0; i < kQuestions; ++i)
    queries.push_back(Generate(Family::kRandom, A, B, kSeed, i));
  std::vector<ContactAnswer> answers(queries.size());
  oracle.Answer(queries, answers);

  const OracleInfo& info = oracle.info();
  PairCheck check;
  check.A = A;
  check.B = B;
  check.asked = queries.size();
  std::vector<Asked> all;
  std::vector<Judged> judged;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    all.push_back({ScenarioOf(queries[i]), ComputeContactTruth(queries[i]), answers[i]});
    const Asked& asked = all.back();
    judged.push_back(Judge(asked.scenario, asked.truth, info, asked.answer));
    if (asked.truth.touching == Touching::kTouching) ++check.touching;
    if (judged.back() == Judged::kRight) ++check.right;
    if (judged.back() == Judged::kUnsupported) ++check.unsupported;
    if (judged.back() == Judged::kInexact) ++check.inexact;
    if (judged.back() != Judged::kWrong) continue;
    if (check.wrong++ == 0) check.example = ExampleOf(info, asked);
  }
  if (check.wrong > 0) check.mistakes = MistakesThatExplain(info, all, judged);
  return check;
}

// The bytes of an answer, without the time that it took. Why there is none is in words,
// which may name an address or a place in a batch.
std::string BytesOf(ContactAnswer answer) {
  answer.seconds = 0;
  if (answer.status != AnswerStatus::kAnswered) answer.reason.clear();
  return ToWire(answer);
}

// The pairs that an oracle supports, A first.
std::vector<std::pair<ShapeKind, ShapeKind>> SupportedPairs(const OracleInfo& oracle) {
  std::vector<std::pair<ShapeKind, ShapeKind>> pairs;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const auto A = static_cast<ShapeKind>(a);
      const auto B = static_cast<ShapeKind>(b);
      const bool are_planes = A == ShapeKind::kHalfSpace && B == ShapeKind::kHalfSpace;
      if (!are_planes && oracle.For(A, B).supported) pairs.emplace_back(A, B);
    }
  }
  return pairs;
}

}  // namespace

std::vector<PairCheck> CheckContacts(const Oracle& oracle) {
  std::vector<PairCheck> checks;
  for (const auto& [A, B] : SupportedPairs(oracle.info()))
    checks.push_back(CheckPair(oracle, A, B));
  return checks;
}

std::string CheckRepeatability(const Oracle& oracle) {
  std::vector<ContactQuery> queries;
  for (const auto& [A, B] : SupportedPairs(oracle.info())) {
    for (std::uint64_t i = 0; i < 4; ++i)
      queries.push_back(Generate(Family::kRandom, A, B, kSeed, i));
  }
  std::vector<ContactAnswer> together(queries.size());
  oracle.Answer(queries, together);
  for (std::size_t i = queries.size(); i-- > 0;) {
    const ContactAnswer alone = oracle.Answer(queries[i]);
    if (BytesOf(alone) == BytesOf(together[i])) continue;
    return fmt::format(
        "a question about {} and {} has another answer when it is asked again, alone and "
        "in "
        "another order{}; expected the same bits, whatever was asked before",
        NameOf(KindOf(queries[i].A.shape)), NameOf(KindOf(queries[i].B.shape)),
        alone.separation && together[i].separation
            ? fmt::format(": separation {} m, then {} m", *together[i].separation,
                          *alone.separation)
            : "");
  }
  return "";
}

}  // namespace touchstone
