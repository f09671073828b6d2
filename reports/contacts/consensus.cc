#include "reports/contacts/consensus.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

#include <fmt/format.h>

#include "reports/contacts/body_size.h"
#include "reports/contacts/tolerances.h"
#include "reports/finding/grade.h"
#include "reports/measures/stated.h"

namespace touchstone {
namespace {

/** One oracle's answer, reduced to what is voted on. */
struct Voter {
  std::string name;
  std::string family;
  bool touching;
  std::optional<double> separation;  ///< [m]
  double tolerance;                  ///< Tolerance of `separation`. [m]
};

std::vector<Voter> VotersOf(const ScenarioResult& result,
                            std::span<const OracleInfo> oracles) {
  const ContactQuery& query = result.scenario.contact;
  std::vector<Voter> voters;
  for (std::size_t i = 0; i < oracles.size(); ++i) {
    const ContactAnswer& answer = result.answers[i];
    if (answer.status != AnswerStatus::kAnswered) continue;
    const Capability& capability =
        oracles[i].For(KindOf(query.A.shape), KindOf(query.B.shape));
    voters.push_back(
        {oracles[i].name, capability.family, answer.touching, SeparationOf(answer),
         TolerancesOf(oracles[i], result.scenario, result.truth, answer.touching)
             .separation});
  }
  return voters;
}

bool SameTouching(const Voter& a, const Voter& b) {
  return a.touching == b.touching;
}

bool SameSeparation(const Voter& a, const Voter& b) {
  // Written so that a NaN differs.
  return a.separation && b.separation &&
         std::abs(*a.separation - *b.separation) <= a.tolerance + b.tolerance;
}

/** The vote of all others on one answer. */
struct Vote {
  int with = 1;     ///< Number of families in favour, its own included.
  int against = 0;  ///< Number of families against.
  const Voter* first_against = nullptr;  ///< The first oracle against it.
};

Vote VoteOn(const Voter& voter, const std::vector<Voter>& voters,
            bool (*same)(const Voter&, const Voter&)) {
  std::map<std::string, bool> agrees;  // Keyed by family.
  Vote vote;
  for (const Voter& other : voters) {
    if (other.family == voter.family) continue;
    const bool with = same(voter, other);
    agrees[other.family] |= with;
    if (!with && vote.first_against == nullptr) vote.first_against = &other;
  }
  for (const auto& [family, with] : agrees) ++(with ? vote.with : vote.against);
  return vote;
}

void Settle(Finding& finding, const Voter& voter, const std::vector<Voter>& voters,
            bool (*same)(const Voter&, const Voter&), const ScenarioResult& result) {
  const Vote vote = VoteOn(voter, voters, same);
  if (vote.against < vote.with) return;
  finding.verdict = Verdict::kDisagree;
  const Voter& other = *vote.first_against;
  // The error of a wrong hit or miss is at most that of the truth.
  const Enclosure& truth = result.truth.separation;
  const double apart = finding.measure == MeasureKind::kTouching
                           ? truth.hi - truth.lo
                           : std::abs(*voter.separation - *other.separation);
  finding.grade = GradeOfShare(apart / SmallerExtent(result.scenario.contact));
  finding.reference = other.name;
  finding.proof = fmt::format(
      "{} differs from {} algorithm families, {} among them, and agrees with {}; the "
      "truth is certified only to lie in [{:.9g}, {:.9g}] m.",
      voter.name, vote.against, other.name, vote.with - 1, truth.lo, truth.hi);
}

}  // namespace

void SettleByConsensus(const ScenarioResult& result, std::span<const OracleInfo> oracles,
                       std::span<Finding> findings) {
  const Enclosure& truth = result.truth.separation;
  const std::vector<Voter> voters = VotersOf(result, oracles);
  for (Finding& finding : findings) {
    const auto voter = std::find_if(voters.begin(), voters.end(), [&](const Voter& v) {
      return v.name == finding.oracle;
    });
    if (voter == voters.end()) continue;
    if (finding.measure == MeasureKind::kTouching &&
        finding.verdict == Verdict::kUndecidable && truth.lo < -voter->tolerance &&
        truth.hi > voter->tolerance) {
      Settle(finding, *voter, voters, SameTouching, result);
    }
    if (finding.measure == MeasureKind::kSeparationError &&
        finding.verdict == Verdict::kUndecidable &&
        truth.hi - truth.lo > voter->tolerance) {
      std::vector<Voter> measured;
      std::copy_if(voters.begin(), voters.end(), std::back_inserter(measured),
                   [](const Voter& v) { return v.separation.has_value(); });
      Settle(finding, *voter, measured, SameSeparation, result);
    }
  }
}

}  // namespace touchstone
