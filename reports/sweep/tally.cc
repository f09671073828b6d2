#include "reports/sweep/tally.h"

#include <algorithm>

namespace touchstone {
namespace {

void Merge(const FindingCounts& other, FindingCounts& counts) {
  for (const auto& [kind, count] : other) counts[kind] += count;
}

void Merge(const OracleTally& other, OracleTally& tally) {
  tally.asked += other.asked;
  tally.touching += other.touching;
  tally.undecided += other.undecided;
  tally.verified += other.verified;
  tally.verified_touching += other.verified_touching;
  Merge(other.findings, tally.findings);
  Merge(other.answers, tally.answers);
  for (const auto& [measurand, sketch] : other.sketches)
    tally.sketches[measurand].Merge(sketch);
  for (const auto& [measurand, worst] : other.worst) {
    for (const WorstFinding& finding : worst) Insert(finding, tally.worst[measurand]);
  }
  for (const auto& [kind, failures] : other.failures) {
    for (const FailedQuestion& failure : failures) Insert(failure, tally.failures[kind]);
  }
}

bool IsGraver(double share, std::uint64_t question, double than_share,
              std::uint64_t than_question) {
  return share != than_share ? share > than_share : question < than_question;
}

}  // namespace

bool IsWorse(const WorstFinding& a, const WorstFinding& b) {
  if (a.tolerances != b.tolerances) return a.tolerances > b.tolerances;
  if (a.share != b.share) return a.share > b.share;
  return a.question < b.question;
}

void Insert(const WorstFinding& finding, std::vector<WorstFinding>& worst) {
  worst.insert(std::upper_bound(worst.begin(), worst.end(), finding, IsWorse), finding);
  if (worst.size() > kWorstKept) worst.pop_back();
}

bool IsKept(std::uint64_t question, double share,
            const std::vector<FailedQuestion>& failures) {
  return failures.size() < kFailuresKept ||
         IsGraver(share, question, failures.back().share, failures.back().question);
}

void Insert(FailedQuestion failure, std::vector<FailedQuestion>& failures) {
  if (!IsKept(failure.question, failure.share, failures)) return;
  const auto place =
      std::upper_bound(failures.begin(), failures.end(), failure,
                       [](const FailedQuestion& a, const FailedQuestion& b) {
                         return IsGraver(a.share, a.question, b.share, b.question);
                       });
  failures.insert(place, std::move(failure));
  if (failures.size() > kFailuresKept) failures.pop_back();
}

const FailedQuestion* GravestFailure(const OracleTally& tally) {
  const FailedQuestion* gravest = nullptr;
  for (const auto& [kind, failures] : tally.failures) {
    const FailedQuestion& of_kind = failures.front();
    if (gravest == nullptr || kind.grade > gravest->kind.grade ||
        (kind.grade == gravest->kind.grade &&
         IsGraver(of_kind.share, of_kind.question, gravest->share, gravest->question))) {
      gravest = &of_kind;
    }
  }
  return gravest;
}

std::uint64_t FailureCount(const OracleTally& tally) {
  std::uint64_t sum = 0;
  for (const auto& [kind, count] : tally.answers) {
    if (IsFailure(kind.verdict)) sum += count;
  }
  return sum;
}

void Merge(const SeriesTally& other, SeriesTally& tally) {
  tally.oracles.resize(std::max(tally.oracles.size(), other.oracles.size()));
  for (std::size_t i = 0; i < other.oracles.size(); ++i)
    Merge(other.oracles[i], tally.oracles[i]);
}

}  // namespace touchstone
