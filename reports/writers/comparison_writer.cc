#include "reports/writers/comparison_writer.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "reports/text/counted.h"
#include "reports/writers/data/data_file.h"
#include "reports/writers/data/json_values.h"
#include "reports/writers/xml_text.h"

namespace touchstone {
namespace {

constexpr std::array kKinds = {ChangeKind::kWorse, ChangeKind::kNotJudged,
                               ChangeKind::kNew, ChangeKind::kGone, ChangeKind::kBetter};

std::size_t CountOf(const Comparison& comparison, ChangeKind kind) {
  return static_cast<std::size_t>(
      std::ranges::count(comparison.changes, kind, &Change::kind));
}

/** Returns the number of changes that fail the later run. */
std::size_t WorseOf(const Comparison& comparison) {
  return CountOf(comparison, ChangeKind::kWorse) +
         CountOf(comparison, ChangeKind::kNotJudged);
}

/** Returns "12 worse, 0 no longer judged, 0 new, 3 gone, 1 better". */
std::string CountsInWords(const Comparison& comparison) {
  std::string words;
  for (const ChangeKind kind : kKinds) {
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", CountOf(comparison, kind),
                         NameOf(kind));
  }
  return words;
}

/** Returns what a change is about: "contact/zoo/fcl_508y: fcl/distance separation_error".
 */
std::string AboutOf(const LedgerCell& cell) {
  return fmt::format("{}: {} {}{}{}", cell.scenario, cell.oracle, NameOf(cell.measure),
                     cell.law.empty() ? "" : " of ", cell.law);
}

DataJson ValueOf(const std::optional<Baseline::Measured>& measured) {
  return measured ? ToData(measured->value, 5) : DataJson(nullptr);
}

DataJson ComparisonData(const Comparison& comparison) {
  DataJson data;
  data["old"] = comparison.before;
  data["new"] = comparison.after;
  data["rows"] = DataJson::array();
  for (const Change& change : comparison.changes) {
    const LedgerCell& cell = change.cell;
    DataJson row;
    row["kind"] = NameOf(change.kind);
    row["question"] = cell.scenario;
    row["oracle"] = cell.oracle;
    row["measure"] = NameOf(cell.measure);
    row["law"] = cell.law;
    row["before"] = ValueOf(change.before);
    row["after"] = ValueOf(change.after);
    row["unit"] = UnitOf(cell.measure);
    row["what"] = change.what;
    data["rows"].push_back(std::move(row));
  }
  return data;
}

}  // namespace

void WriteComparison(const Comparison& comparison, std::ostream& out) {
  constexpr std::size_t kMost = 20;
  for (const ChangeKind kind : kKinds) {
    const std::size_t count = CountOf(comparison, kind);
    if (count == 0) continue;
    out << fmt::format("{} ({})\n", NameOf(kind), count);
    std::size_t shown = 0;
    for (const Change& change : comparison.changes) {
      if (change.kind != kind || shown == kMost) continue;
      ++shown;
      out << fmt::format("  {}: {}\n", AboutOf(change.cell), change.what);
    }
    if (count > shown)
      out << fmt::format("  and {} more; --json FILE has all\n", count - shown);
  }
  const bool is_worse = WorseOf(comparison) > 0;
  out << fmt::format("{}: {} against {}: {}\n", is_worse ? "WORSE" : "NOT WORSE",
                     comparison.after, comparison.before, CountsInWords(comparison));
}

void WriteComparisonJson(const Comparison& comparison, std::ostream& out) {
  DataJson json = {{"format", "touchstone comparison"}, {"version", 1}};
  json.update(ComparisonData(comparison));
  out << json.dump(1, ' ', false, DataJson::error_handler_t::replace) << '\n';
}

void WriteComparisonJUnit(const Comparison& comparison, std::ostream& out) {
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      << fmt::format(
             "<testsuite name=\"touchstone compare\" tests=\"{}\" failures=\"{}\">\n",
             comparison.changes.size(), WorseOf(comparison));
  for (const Change& change : comparison.changes) {
    const std::string name =
        fmt::format("{} {}{}{}", change.cell.oracle, NameOf(change.cell.measure),
                    change.cell.law.empty() ? "" : " of ", change.cell.law);
    out << fmt::format("  <testcase classname=\"{}\" name=\"{}\">",
                       XmlText(change.cell.scenario), XmlText(name));
    if (IsWorse(change.kind)) {
      out << fmt::format("<failure message=\"{}: {}\"/>", NameOf(change.kind),
                         XmlText(change.what));
    } else {
      out << fmt::format("<system-out>{}: {}</system-out>", NameOf(change.kind),
                         XmlText(change.what));
    }
    out << "</testcase>\n";
  }
  out << "</testsuite>\n";
}

std::string WithComparison(const ReadReportData& data, const Comparison& comparison) {
  DataFile file = UnpackData(data.bytes, kMostReportData).file.value();
  file.json["compare"] = ComparisonData(comparison);
  return PackData(file);
}

}  // namespace touchstone
