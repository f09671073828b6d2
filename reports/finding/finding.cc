#include "reports/finding/finding.h"

#include <algorithm>
#include <array>
#include <utility>

#include "reports/finding/decisive.h"

namespace touchstone {

void State(Proof proof, Finding& finding) {
  finding.proof = InWords(proof, finding.oracle);
  finding.cited =
      proof.kind == ProofKind::kPlaces ? Cited{{proof.body}, proof.time, {}} : Cited{};
  finding.evidence = proof.kind == ProofKind::kNone
                         ? nullptr
                         : std::make_shared<const Proof>(std::move(proof));
}

void TakeBackProof(Finding& finding) {
  finding.proof.clear();
  finding.evidence.reset();
  finding.cited = {};
}

bool IsFailure(Verdict verdict) {
  return verdict == Verdict::kFail || verdict == Verdict::kDisagree ||
         IsUnusable(verdict);
}

bool IsUnusable(Verdict verdict) {
  return verdict == Verdict::kCrashed || verdict == Verdict::kTimedOut ||
         verdict == Verdict::kInvalid;
}

bool IsWithinSafety(const Finding& finding) {
  return finding.value > finding.tolerance &&
         finding.value <= finding.tolerance * finding.safety;
}

bool IsVerified(std::span<const Finding> of_one_answer) {
  const auto is_unverified = [](const Finding& finding) {
    return finding.verdict == Verdict::kUnsupported;
  };
  const bool has_unverified =
      std::any_of(of_one_answer.begin(), of_one_answer.end(), is_unverified);
  const Finding* decisive = DecisiveOf(of_one_answer);
  if (decisive != nullptr && decisive->verdict == Verdict::kUndecidable) return false;
  return std::any_of(
      of_one_answer.begin(), of_one_answer.end(), [&](const Finding& finding) {
        return finding.measure != MeasureKind::kAnswering && !is_unverified(finding) &&
               !(has_unverified && finding.reference.empty());
      });
}

std::string_view RecognisedModelOf(const Finding& finding) {
  const bool recognised = finding.reference == "law" &&
                          finding.verdict == Verdict::kPass &&
                          finding.cause == Cause::kModel;
  return recognised ? std::string_view(finding.cause_because) : std::string_view();
}

std::string_view NameOf(Verdict verdict) {
  constexpr std::array<std::string_view, 9> kNames = {
      "pass",        "fail",    "disagree",  "known",  "undecidable",
      "unsupported", "crashed", "timed out", "invalid"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string_view NameOf(Undecided undecided) {
  constexpr std::array<std::string_view, 5> kNames = {
      "sign known and agreed", "truth unknown", "tolerance too coarse", "unverified",
      "sign known and opposed"};
  return kNames[static_cast<std::size_t>(undecided)];
}

std::string_view NameOf(Grade grade) {
  constexpr std::array<std::string_view, kGrades> kNames = {
      "",          "rounding",          "over 1e-6", "over 0.001",
      "over 10 %", "wrong hit or miss", "unusable"};
  return kNames[static_cast<std::size_t>(grade)];
}

std::string_view NameOf(Shipped shipped) {
  constexpr std::array<std::string_view, 4> kNames = {
      "", "both as set here and as shipped", "as set here only", "as shipped only"};
  return kNames[static_cast<std::size_t>(shipped)];
}

std::string_view NameOf(Cause cause) {
  constexpr std::array<std::string_view, 9> kNames = {
      "",      "convention", "tie",    "precision",   "discretisation",
      "model", "setting",    "defect", "not examined"};
  return kNames[static_cast<std::size_t>(cause)];
}

}  // namespace touchstone
