#include "reports/sweep/climb.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reports/contacts/grade.h"
#include "reports/contacts/judge_answer.h"
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
TrueQuestion QuestionAt(const AnySeries& series, std::uint64_t index) {
  TrueQuestion question{ScenarioAt(series, index), {}};
  question.truth = ComputeContactTruth(question.scenario.contact);
  return question;
}

template <typename AnySeries>
TrueQuestions AllQuestionsOf(const AnySeries& block, const Stop& stop) {
  TrueQuestions questions;
  for (std::uint64_t i = block.first; i < block.first + block.count; ++i) {
    if (IsStopped(stop)) return questions;
    TrueQuestion question = QuestionAt(block, i);
    questions.scenarios.push_back(std::move(question.scenario));
    questions.truths.push_back(question.truth);
  }
  return questions;
}

/** Returns the largest error of the subject's answer as a share of the smaller body;
 infinite if it gives no usable answer. [-] */
double ErrorOf(const Oracle& subject, const TrueQuestion& question) {
  const ContactQuery& query = question.scenario.contact;
  if (!subject.info().For(KindOf(query.A.shape), KindOf(query.B.shape)).supported)
    return 0;
  const ContactAnswer answer = subject.Answer(query);
  double error = 0;
  for (const Finding& finding : JudgeAnswer(question.scenario, question.truth,
                                            subject.info(), answer, Reasons::kNone)) {
    if (finding.measure == MeasureKind::kAnswering && finding.verdict != Verdict::kPass) {
      return std::numeric_limits<double>::infinity();
    }
    const bool is_judged =
        finding.verdict == Verdict::kPass || finding.verdict == Verdict::kFail;
    const bool is_length =
        UnitOf(finding.measure) == "m" || finding.measure == MeasureKind::kTouching;
    if (!is_judged || !is_length) continue;
    const double share = ShareOf(finding, query, question.truth);
    if (share > error) error = share;
  }
  return error;
}

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

TrueQuestions QuestionsOf(const QuestionSeries& block, const Stop& stop) {
  return AllQuestionsOf(block, stop);
}

TrueQuestions QuestionsOf(const FileSeries& block, const Stop& stop) {
  return AllQuestionsOf(block, stop);
}

TrueQuestions ClimbOf(const QuestionSeries& block, const Oracle& subject,
                      const Stop& stop) {
  TrueQuestions questions;
  TrueQuestion worst;
  double error = 0;
  const std::uint64_t start = block.first - block.first % block.climb;
  for (std::uint64_t i = start; i < block.first + block.count; ++i) {
    if (IsStopped(stop)) return questions;
    TrueQuestion question = QuestionAt(block, i);
    const bool is_start = i % block.climb == 0;
    if (!is_start) {
      Random random({block.seed, i, static_cast<std::uint64_t>(block.family)});
      question.scenario.contact = Mutated(worst.scenario.contact, random);
      question.truth = ComputeContactTruth(question.scenario.contact);
    }
    const double its_error = ErrorOf(subject, question);
    if (is_start || its_error > error) {
      error = its_error;
      worst = question;
    }
    if (i < block.first) continue;
    questions.scenarios.push_back(std::move(question.scenario));
    questions.truths.push_back(question.truth);
  }
  return questions;
}

}  // namespace touchstone
