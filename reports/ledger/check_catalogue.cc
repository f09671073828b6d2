#include "reports/ledger/check_catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "reports/contacts/checks/excess.h"
#include "reports/contacts/exact_scene.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/outside.h"
#include "reports/measures/overlap_along.h"
#include "reports/referee/referee.h"
#include "reports/text/counted.h"
#include "reports/text/format_vector.h"

namespace touchstone {
namespace {

/** Returns the rounding granted to an expectation: that of the input, and that of a
 double computation. [m] */
double RoundingGranted(const ScenarioResult& result) {
  constexpr double kDouble = 0x1p-53;
  return result.truth.input_rounding +
         kRoundings * kDouble * SceneSize(result.scenario.contact);
}

/** Returns the place of a statement: in the scenario's file, or the id of a scenario that
 has none. */
std::string PlaceOf(const std::string& id, const FilePlaces& places,
                    std::string_view path) {
  if (places.file.empty()) return id;
  const Diagnostic at = ErrorAtValue(places, path, "", "");
  return fmt::format("{}:{}:{}", at.file, at.line, at.column);
}

std::string PlaceOf(const ScenarioResult& result, std::string_view path) {
  return PlaceOf(result.scenario.id, result.scenario.places, path);
}

/** Returns whether the bodies touch; nothing if the rounding of the input decides it. */
std::optional<bool> TouchingOf(const ScenarioResult& result) {
  if (result.truth.touching != Touching::kUndecided)
    return result.truth.touching == Touching::kTouching;
  if (!IsExactScene(result.scenario.contact, 0x1p-53)) return std::nullopt;
  return TouchingInExactScene(result.scenario.contact, result.truth);
}

void CheckTouching(const ScenarioResult& result, std::vector<std::string>& faults) {
  const std::optional<bool> expected = result.scenario.expect.touching;
  if (!expected) return;
  const std::optional<bool> touching = TouchingOf(result);
  if (!touching) {
    faults.push_back(fmt::format(
        "{}: expects touching = {}, which cannot be checked: the separation is "
        "certified to be in [{:.9g}, {:.9g}] m, and the input is rounded by "
        "{:.2g} m. Remove it.",
        PlaceOf(result, "expect.touching"), *expected, result.truth.separation.lo,
        result.truth.separation.hi, result.truth.input_rounding));
    return;
  }
  if (*touching == *expected) return;
  faults.push_back(
      fmt::format("{}: expects touching = {}, but the separation is certified to be in "
                  "[{:.9g}, {:.9g}] m.",
                  PlaceOf(result, "expect.touching"), *expected,
                  result.truth.separation.lo, result.truth.separation.hi));
}

void CheckSeparation(const ScenarioResult& result, std::vector<std::string>& faults) {
  const std::optional<double> expected = result.scenario.expect.separation;
  if (!expected) return;
  const double slack = RoundingGranted(result) + kWritten * std::abs(*expected);
  const Enclosure& truth = result.truth.separation;
  // Written so that an unbounded enclosure is too wide.
  if (!(truth.hi - truth.lo <= slack)) {
    faults.push_back(
        fmt::format("{}: expects separation = {:.12g} m, which cannot be checked: it is "
                    "certified only to be in [{:.12g}, {:.12g}] m. Remove it.",
                    PlaceOf(result, "expect.separation"), *expected, truth.lo, truth.hi));
    return;
  }
  if (Outside(*expected, truth) <= slack) return;
  faults.push_back(
      fmt::format("{}: expects separation = {:.12g} m, but it is certified to be in "
                  "[{:.12g}, {:.12g}] m.",
                  PlaceOf(result, "expect.separation"), *expected, truth.lo, truth.hi));
}

void CheckNormals(const ScenarioResult& result, std::vector<std::string>& faults) {
  const ContactQuery& query = result.scenario.contact;
  // A normal off by kWritten moves a point at the distance of the scene's size by
  // kWritten times that size.
  const double slack = RoundingGranted(result) + kWritten * SceneSize(query);
  const std::vector<Eigen::Vector3d>& normals = result.scenario.expect.normals;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Eigen::Vector3d& n = normals[i];
    const double excess = Excess(query, result.truth, n);
    if (excess <= slack) continue;
    faults.push_back(fmt::format(
        "{}: expects the normal {}, but {} is shorter by {:.9g} m.",
        PlaceOf(result, fmt::format("expect.normals[{}]", i)), FormatVector(n),
        FormatVector(result.truth.certificate.n_AB_W), excess));
  }
}

void CheckContacts(const ScenarioResult& result, std::vector<std::string>& faults) {
  const ContactExpectation& expect = result.scenario.expect;
  if (!expect.contacts) return;
  // If the truth is not known, the patch may belong to a normal other than the true one.
  const Enclosure& truth = result.truth.separation;
  const double slack =
      RoundingGranted(result) + kWritten * SceneSize(result.scenario.contact);
  if (!(truth.hi - truth.lo <= slack)) {
    faults.push_back(fmt::format(
        "{}: expects {}, which cannot be checked: the separation is certified "
        "only to be in [{:.12g}, {:.12g}] m. Remove it.",
        PlaceOf(result, "expect.contacts"), Counted(*expect.contacts, "contact"),
        truth.lo, truth.hi));
    return;
  }
  const ContactQuery& query = result.scenario.contact;
  const auto least_along = [&](const Eigen::Vector3d& n_W, double within) {
    const Eigen::Vector3d n = SupportingDirection(query, n_W);
    const Enclosure overlap = Overlap(query, n);
    return PatchAlong(query, n, -(overlap.lo + overlap.hi) / 2, within).least_contacts;
  };
  const Eigen::Vector3d& certified = result.truth.certificate.n_AB_W;
  const int least =
      least_along(expect.normals.empty() ? certified : expect.normals[0], slack);
  if (least == *expect.contacts) return;
  // The written normal may be too coarse to show which faces are parallel; the certified
  // one is not.
  if (least_along(certified, RoundingGranted(result)) == *expect.contacts) return;
  const auto expected = static_cast<std::uint64_t>(*expect.contacts);
  faults.push_back(fmt::format("{}: expects {}, but it takes {} to span the patch.",
                               PlaceOf(result, "expect.contacts"),
                               Counted(expected, "contact"), least));
}

bool Indicts(const Finding& finding) {
  return finding.verdict == Verdict::kFail || finding.verdict == Verdict::kKnown ||
         IsUnusable(finding.verdict);
}

/** Returns the fault of an indictment for one measure, or "".
 @param place The place of the indictment.
 @param finding The finding for that measure; null where nothing was measured. */
std::string FaultOf(std::string_view place, const Indictment& indictment,
                    MeasureKind measure, const Finding* finding) {
  const bool found = finding != nullptr && Indicts(*finding);
  if (indictment.reproduces) {
    if (found) return "";
    return fmt::format(
        "{}: indicts {} of {} (\"{}\"), which is not reproduced: remove the measure, or "
        "set reproduces = false.",
        place, indictment.oracle, NameOf(measure), indictment.anomaly);
  }
  if (finding == nullptr) {
    return fmt::format(
        "{}: says that {} no longer shows \"{}\", but {} is not measured there: name a "
        "measure that is.",
        place, indictment.oracle, indictment.anomaly, NameOf(measure));
  }
  if (!found) return "";
  return fmt::format(
      "{}: says that {} no longer shows \"{}\", but {} still finds it: {} Set "
      "reproduces = true.",
      place, indictment.oracle, indictment.anomaly, NameOf(measure), finding->proof);
}

/** If every engine breaks a claim of `stable`, the claim itself is probably wrong. */
void CheckStability(RunReport& report) {
  std::map<std::string_view, std::pair<int, int>>
      judged;  // All judged, and those that fail.
  for (const Finding& finding : report.findings) {
    if (finding.measure != MeasureKind::kStability) continue;
    auto& [all, failed] = judged[finding.scenario];
    ++all;
    if (Indicts(finding)) ++failed;
  }
  for (const auto& [scenario, counts] : judged) {
    const auto [all, failed] = counts;
    if (all < 2 || failed < all) continue;
    report.faults.push_back(
        fmt::format("{}: claims to be stable, but each of {} engines amplifies a change "
                    "of its start: is the motion itself unstable?",
                    scenario, all));
  }
}

void CheckIndictments(RunReport& report) {
  const auto indicts = [](const auto& result) {
    return !result.scenario.indicts.empty();
  };
  if (std::none_of(report.scenarios.begin(), report.scenarios.end(), indicts) &&
      std::none_of(report.worlds.begin(), report.worlds.end(), indicts))
    return;
  using Key = std::tuple<std::string_view, std::string_view, MeasureKind>;
  std::map<Key, const Finding*> measured;  // The finding that indicts, if any.
  for (const Finding& finding : report.findings) {
    const Key key(finding.scenario, finding.oracle, finding.measure);
    if (Indicts(finding)) measured.insert_or_assign(key, &finding);
    measured.try_emplace(key, &finding);
  }
  const auto check = [&](const auto& scenario) {
    for (std::size_t i = 0; i < scenario.indicts.size(); ++i) {
      const Indictment& indictment = scenario.indicts[i];
      const bool took_part = std::any_of(
          report.oracles.begin(), report.oracles.end(),
          [&](const OracleInfo& oracle) { return oracle.name == indictment.oracle; });
      if (!took_part) continue;
      for (const MeasureKind measure : indictment.measures) {
        const auto finding = measured.find({scenario.id, indictment.oracle, measure});
        const std::string fault = FaultOf(
            PlaceOf(scenario.id, scenario.places, fmt::format("indicts[{}]", i)),
            indictment, measure, finding == measured.end() ? nullptr : finding->second);
        if (!fault.empty()) report.faults.push_back(fault);
      }
    }
  };
  for (const ScenarioResult& result : report.scenarios) check(result.scenario);
  for (const WorldResult& result : report.worlds) check(result.scenario);
}

}  // namespace

void CheckCatalogue(RunReport& report) {
  for (const ScenarioResult& result : report.scenarios) {
    CheckTouching(result, report.faults);
    CheckSeparation(result, report.faults);
    CheckNormals(result, report.faults);
    CheckContacts(result, report.faults);
  }
  CheckStability(report);
  CheckIndictments(report);
}

}  // namespace touchstone
