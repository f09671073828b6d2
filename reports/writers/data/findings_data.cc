#include "reports/writers/data/findings_data.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace touchstone {
namespace {

constexpr int kDigits = 5;

/** Returns one element of a column for each finding. */
template <typename Value>
DataJson Column(const RunReport& report, Value value) {
  DataJson column = DataJson::array();
  column.get_ref<DataJson::array_t&>().reserve(report.findings.size());
  for (const Finding& finding : report.findings) column.push_back(value(finding));
  return column;
}

std::string_view KindOfUnit(MeasureKind measure) {
  const std::string_view unit = UnitOf(measure);
  if (unit == "m") return "length";
  if (unit == "rad") return "angle";
  if (measure == MeasureKind::kPatchCoverage || measure == MeasureKind::kRestitution)
    return "fraction";
  return unit.empty() ? "count" : "other";
}

}  // namespace

DataJson FindingsData(const RunReport& report, const Clusters& clusters,
                      const std::vector<Moment>& moments, Texts& texts) {
  const std::vector<Finding>& findings = report.findings;
  std::vector<double> times(findings.size(), -1);
  for (const auto& [finding, time] : moments) times[finding] = time;
  // A curve is measured by the tolerance at the worst moment, which is wider than that of
  // an earlier one.
  std::vector<double> first_times = times;
  for (std::size_t f = 0; f < findings.size(); ++f)
    first_times[f] = findings[f].cited.first_time.value_or(first_times[f]);
  // The moment that the proof is about is better than that at which a curve leaves its
  // band.
  for (std::size_t f = 0; f < findings.size(); ++f)
    times[f] = findings[f].cited.time.value_or(times[f]);
  // A column over positions instead of findings.
  const auto at_each = [&](auto value) {
    DataJson column = DataJson::array();
    for (std::size_t f = 0; f < findings.size(); ++f) column.push_back(value(f));
    return column;
  };
  const auto text = [&](auto of) {
    return Column(report, [&](const Finding& f) { return texts.IndexOf(of(f)); });
  };
  DataJson data;
  data["question"] = at_each([&](std::size_t f) { return clusters.places[f].question; });
  data["oracle"] = at_each([&](std::size_t f) { return clusters.places[f].oracle; });
  data["measure"] =
      Column(report, [](const Finding& f) { return static_cast<int>(f.measure); });
  data["law"] = text([](const Finding& f) -> const std::string& { return f.law; });
  data["reference"] =
      text([](const Finding& f) -> const std::string& { return f.reference; });
  data["verdict"] =
      Column(report, [](const Finding& f) { return static_cast<int>(f.verdict); });
  data["undecided"] =
      Column(report, [](const Finding& f) { return static_cast<int>(f.undecided); });
  data["grade"] =
      Column(report, [](const Finding& f) { return static_cast<int>(f.grade); });
  data["cause"] =
      Column(report, [](const Finding& f) { return static_cast<int>(f.cause); });
  data["shipped"] =
      Column(report, [](const Finding& f) { return static_cast<int>(f.shipped); });
  data["value"] =
      Column(report, [](const Finding& f) { return ToData(f.value, kDigits); });
  data["tolerance"] =
      Column(report, [](const Finding& f) { return ToData(f.tolerance, kDigits); });
  data["share"] = at_each([&](std::size_t f) { return ToShare(clusters.shares[f]); });
  data["because"] =
      text([](const Finding& f) -> const std::string& { return f.tolerance_because; });
  data["cause_because"] =
      text([](const Finding& f) -> const std::string& { return f.cause_because; });
  data["shipped_because"] =
      text([](const Finding& f) -> const std::string& { return f.shipped_because; });
  data["proof"] = text([](const Finding& f) -> const std::string& { return f.proof; });
  data["ledger"] =
      Column(report, [](const Finding& f) { return f.ledger_entry.value_or(-1); });
  data["outgrown"] =
      Column(report, [](const Finding& f) { return f.outgrown_entry.value_or(-1); });
  data["cluster"] = at_each([&](std::size_t f) { return clusters.of_finding[f]; });
  data["time"] = at_each([&](std::size_t f) { return ToData(times[f], 6); });
  data["first"] = at_each([&](std::size_t f) { return ToData(first_times[f], 6); });
  return data;
}

DataJson NamesData() {
  DataJson names;
  names["verdict"] = NamesUpTo(Verdict::kInvalid);
  names["undecided"] = NamesUpTo(Undecided::kOpposed);
  names["grade"] = NamesUpTo(Grade::kUnusable);
  names["cause"] = NamesUpTo(Cause::kDefect);  // A run examines every failure.
  names["shipped"] = NamesUpTo(Shipped::kShippedOnly);
  names["measure"] = DataJson::array();
  for (const MeasureKind measure : AllMeasures()) {
    names["measure"].push_back({{"name", NameOf(measure)},
                                {"unit", UnitOf(measure)},
                                {"kind", KindOfUnit(measure)}});
  }
  return names;
}

}  // namespace touchstone
