#include "reports/contacts/checks/answering.h"

#include <string_view>

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/grade.h"
#include "reports/measures/invalidity.h"

namespace touchstone {
namespace {

/** Returns what is wrong with an answer that lacks a promised field; empty if none is
 missing. */
std::string_view MissingField(const JudgedAnswer& judged) {
  const Capability& promised = judged.capability;
  if (!judged.answer.touching) {
    if (promised.distance && !judged.separation)
      return "apart, without the promised distance";
    if (promised.witnesses && !judged.answer.witnesses)
      return "apart, without the promised witness points";
    return "";
  }
  if (promised.depth && !judged.separation) return "touching, without the promised depth";
  // An engine that derives the normal from two witness points has none where they
  // coincide.
  const bool is_deep = judged.truth.separation.hi < -judged.tolerances.separation;
  if (promised.normal && !judged.n_W && is_deep)
    return "touching, without the promised normal";
  if (promised.manifold && judged.answer.points.empty())
    return "touching, without a contact";
  if (promised.penetrating_witnesses && !judged.answer.witnesses)
    return "touching, without the promised witness points";
  return "";
}

}  // namespace

bool CheckIsAnswered(JudgedAnswer& judged) {
  const ContactAnswer& answer = judged.answer;
  switch (answer.status) {
    case AnswerStatus::kAnswered:
      break;
    case AnswerStatus::kUnsupported:
      judged.AddAnswering(Verdict::kUnsupported, answer.reason);
      return false;
    case AnswerStatus::kCrashed:
      judged.AddAnswering(Verdict::kCrashed, answer.reason);
      return false;
    case AnswerStatus::kTimedOut:
      judged.AddAnswering(Verdict::kTimedOut, answer.reason);
      return false;
  }
  const auto fault = InvalidityOf(answer, judged.tolerances.unit_normal);
  if (!fault) return true;
  judged.AddAnswering(Verdict::kInvalid, fault->what).grade = GradeOf(*fault);
  return false;
}

bool CheckIsComplete(JudgedAnswer& judged) {
  const std::string_view missing = MissingField(judged);
  if (missing.empty()) return true;
  judged.AddAnswering(Verdict::kInvalid, missing);
  return false;
}

}  // namespace touchstone
