#include "reports/writers/timings_writer.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "reports/writers/world_sums.h"

namespace touchstone {
namespace {

/** How many of the longest answers and worlds are listed. */
constexpr std::size_t kLongest = 20;

struct Cell {
  double seconds;
  std::size_t question;
  std::size_t oracle;
};

/** Returns the cells that were asked, the longest first. */
std::vector<Cell> LongestFirst(const RunReport& report) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < QuestionCount(report); ++i) {
    for (std::size_t o = 0; o < report.oracles.size(); ++o) {
      if (Answers(report, o, i)) cells.push_back({SecondsOf(report, o, i), i, o});
    }
  }
  std::stable_sort(cells.begin(), cells.end(),
                   [](const Cell& a, const Cell& b) { return a.seconds > b.seconds; });
  return cells;
}

double SumOf(const SecondsByName& sums) {
  double sum = 0;
  for (const auto& [name, seconds] : sums) sum += seconds;
  return sum;
}

/** Writes the sums, the largest first, each with its share of `whole` [s]. Those below a
 hundredth of a second are left out. */
void WriteSums(std::string_view title, const SecondsByName& sums, double whole,
               std::ostream& out) {
  std::vector<std::pair<double, std::string_view>> sorted;
  for (const auto& [name, seconds] : sums) {
    if (seconds >= 0.01) sorted.emplace_back(seconds, name);
  }
  if (sorted.empty()) return;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  out << fmt::format("\n{}\n", title);
  for (const auto& [seconds, name] : sorted)
    out << fmt::format("{:10.2f} s {:4.0f} %  {}\n", seconds, 100 * seconds / whole,
                       name);
}

}  // namespace

void WriteTimings(const RunReport& report, std::ostream& out) {
  const std::vector<Cell> cells = LongestFirst(report);
  SecondsByName oracles;
  for (const Cell& cell : cells)
    oracles[report.oracles[cell.oracle].name] += cell.seconds;
  const double all = SumOf(oracles);
  out << "\nthe longest, on the clock\n";
  for (std::size_t c = 0; c < std::min(kLongest, cells.size()); ++c) {
    out << fmt::format("{:12.4f} s  {}  {}\n", cells[c].seconds,
                       IdOf(report, cells[c].question),
                       report.oracles[cells[c].oracle].name);
  }
  WriteSums("by oracle: answers, and worlds with their judgement", oracles, all, out);
  WriteSums("by kind of motion", SecondsOfMotions(report), all, out);
  WriteSums("by law: the judgement alone", SecondsOfLaws(report), all, out);
  WriteSums("by kind of contact query", report.seconds_of_contacts,
            SumOf(report.seconds_of_contacts), out);
}

}  // namespace touchstone
