#include "reports/triage/root_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/reproduce/engine_code.h"
#include "reports/shrink/shifts.h"
#include "reports/shrink/shrunk_file.h"
#include "reports/text/commented.h"
#include "reports/writers/describe.h"
#include "reports/writers/outcome.h"

namespace touchstone {
namespace {

/** Rows of the table of rates; the most frequent are shown. */
constexpr std::size_t kRows = 20;

/** Returns what was asked, as a sentence. */
std::string AskedOf(const Specimen& specimen) {
  if (const auto* const world = std::get_if<WorldScenario>(&specimen.question))
    return world->title + ".";
  const ScenarioResult& result = specimen.report.scenarios.front();
  const ContactQuery& query = result.scenario.contact;
  return fmt::format("A: {}. B: {}.\n\n{}", Describe(query.A), Describe(query.B),
                     Describe(query, result.truth));
}

/** Returns the part of a report that says what was asked and answered. */
std::string QuestionPart(const Root& root, const RootProgram& program) {
  if (program.files) {
    // Without its own title, and without its last section, the output that it lacks.
    const std::string& report = program.files->report;
    const std::size_t begin = report.find("\n\n");
    return "# " + TitleOf(root) + report.substr(begin, report.find("## Output") - begin);
  }
  const Specimen& smallest = root.smallest();
  return fmt::format(
      "# {}\n\n## Asked\n\n{} {}: {}\n\n## Answer and proof\n\n{}\n\n"
      "There is no program against the library's own API: {}. With Touchstone: "
      "`touchstone run case.toml --subject {} --against {}`.\n\n",
      TitleOf(root), smallest.oracle->info().library, smallest.oracle->info().version,
      AskedOf(smallest), Sentence(smallest.finding), program.reason,
      smallest.oracle->info().name, smallest.oracle->info().name);
}

std::string_view Introduction(ProgramEnding ending) {
  switch (ending) {
    case ProgramEnding::kShowsFault:
      return "";
    case ProgramEnding::kShowsNone:
      return "The program does not show the fault on this machine. It printed:\n\n";
    case ProgramEnding::kNotBuilt:
      return "The program could not be built on this machine:\n\n";
    case ProgramEnding::kUnfinished:
      return "The program did not come to its end on this machine. It printed:\n\n";
  }
  return "";
}

std::string OutputPart(const RootProgram& program,
                       const std::optional<ProgramOutput>& output) {
  if (!program.files) return "";
  if (!output) return "## Output\n\nThe program has not been run.\n\n";
  std::string block;
  std::string line;
  for (const char c : output->text + (output->text.ends_with('\n') ? "" : "\n")) {
    if (c != '\n') {
      line += c;
      continue;
    }
    block += line.empty() ? "\n" : "    " + line + "\n";
    line.clear();
  }
  return fmt::format("## Output\n\n{}{}\n", Introduction(output->ending), block);
}

std::string RatePart(const Root& root) {
  std::vector<std::pair<Rate, std::string>> rows;
  for (const auto& [of, rate] : root.rates)
    rows.emplace_back(rate, fmt::format("| {} | {} |", of.first, of.second));
  std::ranges::stable_sort(rows, [](const auto& a, const auto& b) {
    return ShareOf(a.first) > ShareOf(b.first);
  });
  std::string table = "| oracle | questions | failed |\n|---|---|---|\n";
  for (std::size_t i = 0; i < rows.size() && i < kRows; ++i)
    table += fmt::format("{} {} |\n", rows[i].second, ToString(rows[i].first));
  if (rows.size() > kRows)
    table += fmt::format("| … | {} more | |\n", rows.size() - kRows);
  return fmt::format(
      "## How common\n\n{} of {} answers, {:.3g} %, to the questions of the families "
      "and files below. Intervals are those of 95 %.\n\n{}\n",
      root.rate.failed, root.rate.asked, 100 * ShareOf(root.rate), table);
}

std::string NeighbourhoodPart(const Root& root) {
  const Specimen& smallest = root.smallest();
  std::string text = smallest.is_smallest ? ""
                                          : "## Smaller questions\n\nThe search for a "
                                            "smaller question ended early. There "
                                            "may be one.\n\n";
  if (!smallest.shifts) return text;
  return text + fmt::format(
                    "## Neighbourhood\n\nThe same fault, by the same measure and proof "
                    "and at least "
                    "half "
                    "as large, is in {} of {} questions in which B is moved and turned "
                    "by 1 % of the "
                    "smallest radius or half side.\n\n",
                    *smallest.shifts, kShifts);
}

std::string KnownPart(const std::vector<std::string>& known) {
  if (known.empty()) return "## Known\n\nThe ledger of known faults has none like it.\n";
  return fmt::format(
      "## Known\n\nThe ledger has faults of these oracles with these measures and "
      "verdicts; "
      "it may be one of them:\n\n- {}\n",
      fmt::join(known, "\n- "));
}

}  // namespace

std::string CaseFile(const Root& root) {
  const Specimen& smallest = root.smallest();
  const Shrunk shrunk{.question = smallest.question,
                      .finding = smallest.finding,
                      .shifts = smallest.shifts};
  return Commented(fmt::format("From {}.", IdOf(smallest.original)), "# ") +
         Commented(Sentence(smallest.finding), "# ") +
         TextOf(ScenarioOf(shrunk, smallest.original));
}

RootProgram ProgramOf(const Root& root) {
  const Specimen& smallest = root.smallest();
  const OracleInfo& oracle = smallest.oracle->info();
  try {
    if (std::holds_alternative<WorldScenario>(smallest.question)) {
      return {Reproduce(smallest.report.worlds.front(), oracle, smallest.finding), ""};
    }
    return {Reproduce(smallest.report.scenarios.front(), oracle, smallest.finding), ""};
  } catch (const CannotReproduce& error) {
    return {std::nullopt, error.what()};
  }
}

std::string ReportOf(const Root& root, const RootProgram& program,
                     const std::optional<ProgramOutput>& output,
                     const std::vector<std::string>& known) {
  return QuestionPart(root, program) + OutputPart(program, output) + RatePart(root) +
         NeighbourhoodPart(root) + KnownPart(known);
}

}  // namespace touchstone
