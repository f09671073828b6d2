#include "reports/contacts/judge_answer.h"

#include <utility>

#include "reports/contacts/checks/answering.h"
#include "reports/contacts/checks/consistency_error.h"
#include "reports/contacts/checks/contact_off_patch.h"
#include "reports/contacts/checks/contact_separation_error.h"
#include "reports/contacts/checks/contact_surface_error.h"
#include "reports/contacts/checks/contact_too_deep.h"
#include "reports/contacts/checks/duality_gap.h"
#include "reports/contacts/checks/excess.h"
#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/mixed_normals.h"
#include "reports/contacts/checks/patch_coverage.h"
#include "reports/contacts/checks/separation_error.h"
#include "reports/contacts/checks/touching.h"
#include "reports/contacts/checks/witness_error.h"

namespace touchstone {
namespace {

/** The checks of a complete answer, in their order: some apply only where an earlier one
 has passed. */
constexpr void (*kChecks[])(JudgedAnswer&) = {
    CheckSeparation,         CheckConsistency,     CheckNormal,
    CheckDualityGap,         CheckWitnesses,       CheckSurfacePoints,
    CheckContactSeparations, CheckContactsInPatch, CheckCoverage,
    CheckDeepestContact,     CheckMixedNormals,
};

}  // namespace

std::vector<Finding> JudgeAnswer(const Scenario& scenario, const ContactTruth& truth,
                                 const OracleInfo& oracle, const ContactAnswer& answer,
                                 Reasons reasons) {
  JudgedAnswer judged(scenario, truth, oracle, answer, reasons);
  if (!CheckIsAnswered(judged)) return std::move(judged).Findings();
  CheckTouching(judged);
  if (!CheckIsComplete(judged)) return std::move(judged).Findings();
  for (const auto check : kChecks) check(judged);
  judged.AddAnswering(Verdict::kPass, "");
  return std::move(judged).Findings();
}

}  // namespace touchstone
