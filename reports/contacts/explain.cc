#include "reports/contacts/explain.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "reports/contacts/causes/convention.h"
#include "reports/contacts/causes/over_geometries.h"
#include "reports/contacts/causes/tie.h"
#include "reports/contacts/causes/unexplained.h"
#include "reports/contacts/normal_claim.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/stated.h"

namespace touchstone {
namespace {

/** Sets the cause `model` on a pass whose error is larger than rounding: only the
 documented error, or a tolerance that a person stated, lets it pass. */
void ExplainByModel(const ScenarioResult& result, const OracleInfo& oracle,
                    Finding& finding) {
  const ContactQuery& query = result.scenario.contact;
  const Capability& capability = oracle.For(KindOf(query.A.shape), KindOf(query.B.shape));
  const bool documented =
      capability.documented_error > 0 || capability.documented_relative_error > 0;
  const double rounding = RoundingOf(oracle, query) + result.truth.input_rounding;
  const bool stated = !oracle.tolerance.IsZero();
  if (UnitOf(finding.measure) != "m" || finding.value <= rounding) return;
  if (!documented && !stated) return;
  finding.cause = Cause::kModel;
  finding.cause_because =
      fmt::format("{:.3g} m is more than rounding, and {}{}{}", finding.value,
                  documented ? "documented: " + capability.documented_by : "",
                  documented && stated ? "; " : "",
                  stated ? "granted as stated by " + oracle.tolerance.by : "");
}

}  // namespace

void ExplainByAnswer(const ScenarioResult& result, const OracleInfo& oracle,
                     const ContactAnswer& answer, std::span<Finding> findings) {
  std::vector<Finding*> of_answer;
  for (Finding& finding : findings) {
    if (finding.verdict == Verdict::kPass) ExplainByModel(result, oracle, finding);
    const ContactQuery& query = result.scenario.contact;
    const Capability& capability =
        oracle.For(KindOf(query.A.shape), KindOf(query.B.shape));
    if (finding.measure == MeasureKind::kExcess && finding.verdict == Verdict::kPass &&
        ClaimsLeastDirection(result.truth, capability, answer)) {
      const auto tie = TieOf(result.truth, NormalOf(answer).value());
      if (tie) {
        finding.cause = Cause::kTie;
        finding.cause_because = *tie;
      }
    }
    if (finding.reference == "referee") of_answer.push_back(&finding);
  }
  const bool any = std::any_of(of_answer.begin(), of_answer.end(),
                               [](const Finding* f) { return IsUnexplained(*f); });
  if (any) ExplainByConvention(result.scenario, result.truth, oracle, answer, of_answer);
}

void ExplainTheRest(std::span<const ScenarioResult> results,
                    std::span<const OracleInfo> oracles, std::span<Finding> findings) {
  ExplainByMargins(results, oracles, findings);
  RefuseConventions(results, oracles, findings);
  for (Finding& finding : findings) {
    if (IsUnexplained(finding)) {
      finding.cause = Cause::kDefect;
      finding.cause_because =
          "no known convention, tie, rounding or model accounts for it";
    } else if (IsUnusable(finding.verdict)) {
      finding.cause = Cause::kDefect;
      finding.cause_because = "a valid question, without a usable answer";
    }
  }
}

}  // namespace touchstone
