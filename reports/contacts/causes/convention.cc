#include "reports/contacts/causes/convention.h"

#include <algorithm>
#include <cmath>

#include "reports/contacts/causes/unexplained.h"
#include "reports/contacts/checks/excess.h"
#include "reports/contacts/checks/separation_error.h"
#include "reports/contacts/judge_answer.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/outside.h"
#include "reports/measures/stated.h"

namespace touchstone {
namespace {

void FlipNormals(ContactAnswer& answer) {
  if (answer.n_AB_W) *answer.n_AB_W *= -1;
  for (ContactPoint& contact : answer.points) {
    if (contact.n_AB_W) *contact.n_AB_W *= -1;
  }
}

void ScaleSeparations(ContactAnswer& answer, double factor) {
  if (answer.separation) *answer.separation *= factor;
  for (ContactPoint& contact : answer.points) contact.separation *= factor;
}

/** Moves contacts along the normal by the fraction `share` of their separation. */
void ShiftContacts(ContactAnswer& answer, const Eigen::Vector3d& n_AB_W, double share) {
  for (ContactPoint& contact : answer.points) {
    const Eigen::Vector3d n = contact.n_AB_W.value_or(n_AB_W);
    contact.p_WC += n * (share * contact.separation);
  }
}

struct ScaleConvention {
  double factor;  ///< Factor from such a separation to ours. [-]
  const char* name;
};

constexpr ScaleConvention kScales[] = {
    {-1, "its separation has the other sign"},
    {2, "its separation is half of what it is along the normal"},
    {0.5, "its separation is twice what it is along the normal"},
};

struct PlaceConvention {
  double share;
  const char* name;
};

// The points on A and B are p ∓ n s/2: the midpoint is n s/2 from the point on A, and -n
// s/2 from the point on B.
constexpr PlaceConvention kPlaces[] = {
    {0.5, "its contacts lie on the surface of A, not midway"},
    {-0.5, "its contacts lie on the surface of B, not midway"},
};

std::string Both(const std::string& a, const std::string& b) {
  return a.empty() ? b : a + ", and " + b;
}

/** Adds to `readings` a copy of the answer and of each reading, with the contacts moved
 midway from either surface. */
void AddPlaces(std::vector<Reading>& readings, const ContactAnswer& answer) {
  const std::vector<Reading> so_far = readings;
  const auto add = [&](const Reading& reading) {
    const auto n_AB_W = NormalOf(reading.answer);
    if (!n_AB_W || reading.answer.points.empty()) return;
    for (const PlaceConvention& place : kPlaces) {
      Reading shifted = reading;
      ShiftContacts(shifted.answer, *n_AB_W, place.share);
      shifted.convention = Both(reading.convention, place.name);
      readings.push_back(std::move(shifted));
    }
  };
  add({answer, ""});
  for (const Reading& reading : so_far) add(reading);
}

const Finding* Find(const std::vector<Finding>& findings, MeasureKind measure) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const Finding& f) { return f.measure == measure; });
  return found == findings.end() ? nullptr : &*found;
}

/** Returns whether a measure that passes for the answer fails for its reading. */
bool Breaks(const std::vector<Finding>& reading, const std::vector<Finding*>& findings) {
  return std::any_of(findings.begin(), findings.end(), [&](const Finding* finding) {
    const Finding* again = Find(reading, finding->measure);
    return !IsProvedWrong(*finding) && again != nullptr && IsProvedWrong(*again);
  });
}

}  // namespace

std::vector<Reading> ReadingsOf(const Scenario& scenario, const ContactTruth& truth,
                                const OracleInfo& oracle, const ContactAnswer& answer) {
  const Tolerances tolerances = TolerancesOf(oracle, scenario, truth, answer.touching);
  const double e = tolerances.separation;
  std::vector<Reading> readings;

  const auto n_AB_W = NormalOf(answer);
  const bool is_flipped = n_AB_W &&
                          Excess(scenario.contact, truth, *n_AB_W) > tolerances.excess &&
                          Excess(scenario.contact, truth, -*n_AB_W) <= tolerances.excess;
  if (is_flipped) {
    Reading flipped{answer, "its normal points from B to A"};
    FlipNormals(flipped.answer);
    readings.push_back(std::move(flipped));
  }

  const double from_zero = Outside(0, truth.separation);
  if (from_zero < kClearOfZero * e) return readings;

  const auto separation = SeparationOf(answer);
  if (separation && SeparationError(truth, *separation) > e) {
    const std::vector<Reading> so_far = readings;
    for (const ScaleConvention& scale : kScales) {
      if (SeparationError(truth, scale.factor * *separation) >
          std::abs(scale.factor) * e) {
        continue;
      }
      Reading scaled{answer, scale.name};
      ScaleSeparations(scaled.answer, scale.factor);
      readings.push_back(scaled);
      for (const Reading& reading : so_far) {
        Reading both = reading;
        ScaleSeparations(both.answer, scale.factor);
        both.convention = Both(reading.convention, scale.name);
        readings.push_back(std::move(both));
      }
    }
  }
  AddPlaces(readings, answer);
  return readings;
}

void ExplainByConvention(const Scenario& scenario, const ContactTruth& truth,
                         const OracleInfo& oracle, const ContactAnswer& answer,
                         std::vector<Finding*>& findings) {
  for (const Reading& reading : ReadingsOf(scenario, truth, oracle, answer)) {
    const std::vector<Finding> judged =
        JudgeAnswer(scenario, truth, oracle, reading.answer, Reasons::kNone);
    if (Breaks(judged, findings)) continue;
    for (Finding* finding : findings) {
      if (!IsUnexplained(*finding)) continue;
      const Finding* again = Find(judged, finding->measure);
      if (again == nullptr || again->verdict != Verdict::kPass) continue;
      finding->cause = Cause::kConvention;
      finding->cause_because = reading.convention;
    }
  }
}

}  // namespace touchstone
