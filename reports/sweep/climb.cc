#include "reports/sweep/climb.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reports/contacts/grade.h"
#include "reports/contacts/judge_answer.h"
#include "reports/finding/ending.h"
#include "reports/referee/referee.h"
#include "scenarios/generators/portable_math.h"
#include "scenarios/generators/random.h"
#include "scenarios/validate.h"

namespace touchstone {
namespace {

struct TrueQuestion {
  Scenario scenario;
  ContactTruth truth;
};

template <typename AnySeries>
TrueQuestions AllQuestionsOf(const AnySeries& block) {
  TrueQuestions questions;
  for (std::uint64_t i = block.first; i < block.first + block.count; ++i) {
    questions.scenarios.push_back(ScenarioAt(block, i));
    questions.truths.push_back(ComputeContactTruth(questions.scenarios.back().contact));
  }
  return questions;
}

/** A fault as a climb tells it from others: its measure, and how a missing answer ended.
 */
using FaultKind = std::pair<MeasureKind, std::string>;

/** An error of a length, as a share of the smaller body. */
struct ShareOfError {
  FaultKind kind;
  double share = 0;         ///< [-]
  bool is_gravest = false;  ///< Whether it is a fault that cannot become graver.
};

/** Returns the errors of the subject's answer; one that is infinite if it gives no usable
 answer. */
std::vector<ShareOfError> ErrorsOf(const Oracle& subject, const TrueQuestion& question) {
  const ContactQuery& query = question.scenario.contact;
  if (!subject.info().For(KindOf(query.A.shape), KindOf(query.B.shape)).supported)
    return {};
  const ContactAnswer answer = subject.Answer(query);
  std::vector<ShareOfError> errors;
  for (const Finding& finding : JudgeAnswer(question.scenario, question.truth,
                                            subject.info(), answer, Reasons::kNone)) {
    if (finding.measure == MeasureKind::kAnswering && finding.verdict != Verdict::kPass) {
      return {{.kind = {finding.measure, KindOfProof(answer.reason)},
               .share = std::numeric_limits<double>::infinity(),
               .is_gravest = true}};
    }
    const bool is_fault = finding.verdict == Verdict::kFail;
    const bool is_length =
        UnitOf(finding.measure) == "m" || finding.measure == MeasureKind::kTouching;
    if (!(finding.verdict == Verdict::kPass || is_fault) || !is_length) continue;
    errors.push_back({.kind = {finding.measure, ""},
                      .share = ShareOf(finding, query, question.truth),
                      .is_gravest = is_fault && finding.grade >= Grade::kGross});
  }
  return errors;
}

/** The search for faults that it has not found yet. */
class Climb {
 public:
  /** Whether the next question is one of the family. */
  bool begins() const { return begins_; }
  const TrueQuestion& worst() const { return worst_; }

  /** Takes the answer to the next question into account. */
  void Take(const TrueQuestion& question, const std::vector<ShareOfError>& errors) {
    const bool is_worst = begins_ || UnseenIn(errors) > error_;
    if (is_worst) worst_ = question;
    begins_ = false;
    for (const ShareOfError& error : errors) {
      if (error.is_gravest && found_.insert(error.kind).second) begins_ = true;
    }
    if (is_worst) error_ = UnseenIn(errors);
  }

 private:
  /** Returns the largest error of a kind that was not found yet. [-] */
  double UnseenIn(const std::vector<ShareOfError>& errors) const {
    double unseen = 0;
    for (const ShareOfError& error : errors) {
      // A NaN is no error to climb from.
      if (error.share > unseen && !found_.contains(error.kind)) unseen = error.share;
    }
    return unseen;
  }

  std::set<FaultKind> found_;
  TrueQuestion worst_;
  double error_ = 0;  ///< UnseenIn() the answer to `worst_`.
  bool begins_ = true;
};

/** Returns `query` with B moved, turned and resized by random amounts. */
ContactQuery Mutated(const ContactQuery& query, Random& random) {
  ContactQuery result = query;
  Body& B = result.B;
  const double moves = random.Decades(-6, 0);
  const double turns = random.Decades(-6, 0);
  const double grows = random.Decades(-6, 0);
  const Eigen::Vector3d p_AB_W = query.B.X_WB.p_WB - query.A.X_WB.p_WB;
  const Eigen::Vector3d p_WB =
      query.B.X_WB.p_WB + moves * Norm(p_AB_W) * random.Direction();
  const Eigen::Quaterniond q_turn = RotationByHalfTangent(random.Direction(), turns / 2);
  B.X_WB =
      query.B.X_WB.q_WB
          ? Pose::FromQuaternion(p_WB, Product(q_turn, *query.B.X_WB.q_WB))
          : Pose::FromMatrix(p_WB, Product(q_turn.toRotationMatrix(), query.B.X_WB.R_WB));
  const bool is_resized = random.Coin();
  const double factor = 1 + random.Sign() * grows / 2;
  if (is_resized) B.shape = Resized(B.shape, factor);
  return FaultsOf(result).empty() ? result : query;
}

}  // namespace

TrueQuestions QuestionsOf(const QuestionSeries& block) {
  return AllQuestionsOf(block);
}

TrueQuestions QuestionsOf(const FileSeries& block) {
  return AllQuestionsOf(block);
}

TrueQuestions ClimbOf(const QuestionSeries& block, const Oracle& subject) {
  TrueQuestions questions;
  Climb climb;
  const std::uint64_t start = block.first - block.first % block.climb;
  for (std::uint64_t i = start; i < block.first + block.count; ++i) {
    if (i % block.climb == 0) climb = Climb();
    TrueQuestion question{ScenarioAt(block, i), {}};
    if (!climb.begins()) {
      Random random({block.seed, i, static_cast<std::uint64_t>(block.family)});
      question.scenario.contact = Mutated(climb.worst().scenario.contact, random);
    }
    question.truth = ComputeContactTruth(question.scenario.contact);
    climb.Take(question, ErrorsOf(subject, question));
    if (i < block.first) continue;
    questions.scenarios.push_back(std::move(question.scenario));
    questions.truths.push_back(question.truth);
  }
  return questions;
}

}  // namespace touchstone
