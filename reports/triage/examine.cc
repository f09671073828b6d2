#include "reports/triage/examine.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "reports/contacts/judge_variant.h"
#include "reports/finding/decisive.h"
#include "reports/finding/ending.h"
#include "reports/shrink/same_fault.h"
#include "reports/shrink/shrink.h"
#include "reports/triage/kept_question.h"

namespace touchstone {
namespace {

/** The number of answers that may time out while a question is shrunk: twenty seconds. */
constexpr std::size_t kHangs = 10;

/** Returns the finding of the symptom, if `report` has one. */
const Finding* SymptomIn(const RunReport& report, const Symptom::Key& key) {
  const auto found = std::ranges::find_if(report.findings, [&](const Finding& finding) {
    return finding.measure == key.measure && finding.verdict == key.verdict &&
           finding.law == key.law && EndingOf(finding) == key.ending;
  });
  return found == report.findings.end() ? nullptr : &*found;
}

/** Returns the decisive fault of a report of one answer: of the answer itself or, if that
 is right, of a variant. Nothing if the oracle is right. */
std::optional<Finding> FaultIn(const RunReport& report) {
  std::vector<Finding> of_answer;
  std::vector<Finding> of_variants;
  for (const Finding& finding : report.findings) {
    if (!IsFailure(finding.verdict)) continue;
    (IsOfAVariant(finding.measure) ? of_variants : of_answer).push_back(finding);
  }
  const Finding* const decisive = DecisiveOf(of_answer.empty() ? of_variants : of_answer);
  return decisive == nullptr ? std::nullopt : std::optional(*decisive);
}

/** Returns the fault of the answer that `symptom` is likely to follow from: a wrong depth
 or normal moves the surfaces on which contacts are judged, and measures are enumerated in
 that order. It must be large enough. A depth moves the surfaces by its error. A normal
 off by the angle θ costs the share θ² of a depth and moves them by the share θ, and the
 bounds of the grades are 1e-6, 1e-3 and 0.1: its own fault may be one grade milder. */
const Finding& SourceOf(const RunReport& report, const Finding& symptom) {
  if (!report.worlds.empty() || IsOfAVariant(symptom.measure)) return symptom;
  const Finding* source = &symptom;
  for (const Finding& finding : report.findings) {
    const int milder = IsOfANormal(report, finding) ? 1 : 0;
    if (finding.verdict == symptom.verdict && !IsOfAVariant(finding.measure) &&
        static_cast<int>(finding.grade) + milder >= static_cast<int>(symptom.grade) &&
        finding.measure < source->measure)
      source = &finding;
  }
  return *source;
}

/** A question with a fault of its own. */
struct Found {
  Question question;
  RunReport report;
  Finding finding;
};

/** Returns a variant of `scenario` that the oracle answers wrongly by itself. */
std::optional<Found> WrongVariant(const Scenario& scenario, MeasureKind measure,
                                  const Oracle& oracle) {
  for (const Variant& variant : VariantsOf(scenario)) {
    if (variant.measure != measure) continue;
    Scenario varied = scenario;
    varied.contact = variant.query;
    if (!IsValid(varied)) continue;
    RunReport report = AskAlone(varied, oracle);
    std::optional<Finding> fault = FaultIn(report);
    if (fault && !IsOfAVariant(fault->measure))
      return Found{std::move(varied), std::move(report), std::move(*fault)};
  }
  return std::nullopt;
}

/** Returns the question and the fault to shrink. Nothing if the oracle does not show the
 symptom again. */
std::optional<Found> FaultOf(const Symptom& symptom, const Question& original,
                             const Oracle& oracle) {
  RunReport report = AskAlone(original, oracle);
  const Finding* const again = SymptomIn(report, symptom.key);
  if (again == nullptr) return std::nullopt;
  Finding fault = SourceOf(report, *again);
  if (IsOfAVariant(fault.measure)) {
    if (auto found =
            WrongVariant(std::get<Scenario>(original), symptom.key.measure, oracle)) {
      return found;
    }
    fault = FaultIn(report).value();
  }
  return Found{original, std::move(report), std::move(fault)};
}

}  // namespace

bool IsOfAVariant(MeasureKind measure) {
  return measure >= MeasureKind::kSwap && measure <= MeasureKind::kPerturbation;
}

bool IsOfANormal(const RunReport& report, const Finding& finding) {
  if (finding.measure == MeasureKind::kExcess) return true;
  return finding.measure == MeasureKind::kConsistencyError &&
         std::ranges::any_of(report.findings, [](const Finding& other) {
           return other.measure == MeasureKind::kSeparationError &&
                  other.verdict == Verdict::kPass;
         });
}

Specimen AskAgain(const Symptom& symptom, const Oracle& oracle) {
  Specimen specimen;
  specimen.symptoms = {symptom};
  specimen.oracle = &oracle;
  for (const FailedQuestion& kept : symptom.kept) {
    Question question = QuestionOf(kept);
    std::optional<Found> fault = FaultOf(symptom, question, oracle);
    if (!fault) continue;
    specimen.is_repeatable = true;
    specimen.original = std::move(question);
    specimen.question = std::move(fault->question);
    specimen.report = std::move(fault->report);
    specimen.finding = std::move(fault->finding);
    return specimen;
  }
  specimen.original = QuestionOf(symptom.kept.front());
  return specimen;
}

Specimen Smallest(Specimen specimen, const SmallestOptions& options) {
  const Oracle& oracle = *specimen.oracle;
  Shrunk shrunk = Shrink(specimen.question, oracle, specimen.finding,
                         {.tries = options.tries, .hangs = kHangs, .stop = options.stop});
  RunReport report = AskAlone(shrunk.question, oracle);
  // An engine that answers by chance may be right the last time.
  if (!std::ranges::any_of(report.findings, [&](const Finding& finding) {
        return IsSameFault(finding, shrunk.finding);
      })) {
    return specimen;
  }
  specimen.question = std::move(shrunk.question);
  specimen.report = std::move(report);
  specimen.finding = std::move(shrunk.finding);
  specimen.is_smallest = shrunk.is_smallest;
  specimen.shifts = shrunk.shifts;
  return specimen;
}

}  // namespace touchstone
