#include "reports/triage/root_files.h"

#include <sstream>
#include <variant>

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

/** Returns `text` as a block of code in Markdown. */
std::string CodeBlock(const std::string& text) {
  std::string block;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    block += line.empty() ? "\n" : "    " + line + "\n";
  return block;
}

/** Returns `question` with another id. */
Question Renamed(Question question, const std::string& id) {
  std::visit([&id](auto& scenario) { scenario.id = id; }, question);
  return question;
}

/** Returns what was asked, in words and with its exact numbers. */
std::string AskedOf(const Specimen& specimen) {
  if (const auto* const world = std::get_if<WorldScenario>(&specimen.question)) {
    WorldScenario bare = *world;
    bare.indicts.clear();
    return fmt::format(
        "this world, in metres, kilograms and seconds. Sizes are halves, places those of "
        "the centres, quaternions are (w, x, y, z).\n\n{}",
        CodeBlock(TextOf(Question(bare))));
  }
  const ScenarioResult& result = specimen.report.scenarios.front();
  const ContactQuery& query = result.scenario.contact;
  return fmt::format("A: {}. B: {}.\n\n## Truth\n\n{}\n", Describe(query.A),
                     Describe(query.B), Describe(query, result.truth));
}

/** Returns how the engine was set up: what differs from its defaults. */
std::string SettingsPart(const Specimen& specimen) {
  const OracleInfo& oracle = specimen.oracle->info();
  std::string list;
  if (std::holds_alternative<WorldScenario>(specimen.question)) {
    const std::vector<double> values = ValuesOf(oracle.parameters, oracle.setup);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const WorldParameter& parameter = oracle.parameters[i];
      if (values[i] == parameter.shipped) continue;
      list += fmt::format("- {} = {}, by default {}: {}\n", parameter.name, values[i],
                          parameter.shipped, parameter.what);
    }
  } else {
    for (const Setting& setting : oracle.settings)
      list += fmt::format("- {}: {}\n", setting.name, setting.value);
  }
  return list.empty() ? "" : "## Settings\n\n" + list + "\n";
}

/** Returns the size of the fault, of an answer that has one. */
std::string ErrorOf(const Finding& finding) {
  if (finding.verdict != Verdict::kFail || finding.measure == MeasureKind::kTouching)
    return "";
  return fmt::format(
      "\n\nThe error is {:.3g}{} where {:.3g} is allowed: {}.", finding.value,
      UnitOf(finding.measure).empty() ? "" : fmt::format(" {}", UnitOf(finding.measure)),
      finding.tolerance, finding.tolerance_because);
}

/** Returns why the answer is wrong, as far as it is known. */
std::string CausePart(const Finding& finding) {
  std::string text;
  if (finding.cause != Cause::kNone && finding.cause != Cause::kDefect &&
      !finding.cause_because.empty())
    text += fmt::format("{}: {}.\n\n", NameOf(finding.cause), finding.cause_because);
  if (finding.shipped != Shipped::kNotAsked) {
    text += fmt::format("{}: {}.\n\n", NameOf(finding.shipped), finding.shipped_because);
  }
  return text.empty() ? "" : "## Cause\n\n" + text;
}

/** Returns why a root is no matter for the tracker, if it is none. */
std::string NoteOf(const Root& root) {
  return IsOfASetting(root) ? "Not for the tracker: as the engine ships, it passes. A "
                              "setting of Touchstone's adapter is at fault.\n\n"
                            : "";
}

/** Returns the part of a report that says what was asked and answered. */
std::string QuestionPart(const Root& root, const RootProgram& program) {
  const std::string head = fmt::format("# {}\n\n{}", TitleOf(root), NoteOf(root));
  if (program.files) return head + program.files->report;
  const Specimen& smallest = root.smallest();
  return fmt::format(
      "{head}## Asked\n\n{library} {version}: {asked}\n"
      "{settings}## Answer and proof\n\n{proof}{error}\n\n"
      "There is no program against the library's own API: {reason}. With Touchstone: "
      "`touchstone run case.toml --subject {oracle} --against {oracle}`.\n\n",
      fmt::arg("head", head), fmt::arg("library", smallest.oracle->info().library),
      fmt::arg("version", smallest.oracle->info().version),
      fmt::arg("asked", AskedOf(smallest)), fmt::arg("settings", SettingsPart(smallest)),
      fmt::arg("proof", smallest.finding.proof),
      fmt::arg("error", ErrorOf(smallest.finding)), fmt::arg("reason", program.reason),
      fmt::arg("oracle", smallest.oracle->info().name));
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
  return fmt::format("## Output\n\n{}{}\n", Introduction(output->ending),
                     CodeBlock(output->text));
}

std::string RatePart(const Root& root) {
  std::vector<std::pair<Rate, std::string>> rows;
  for (const auto& [of, rate] : root.rates)
    rows.emplace_back(rate, fmt::format("| {} | {} |", of.first, of.second));
  std::ranges::stable_sort(rows, [](const auto& a, const auto& b) {
    return ShareOf(a.first) > ShareOf(b.first);
  });
  std::string table = "| asked as | questions | failed |\n|---|---|---|\n";
  Rate others;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i < kRows && rows[i].first.failed > 0) {
      table += fmt::format("{} {} |\n", rows[i].second, ToString(rows[i].first));
    } else {
      others += rows[i].first;
    }
  }
  if (others.asked > 0)
    table += fmt::format("| all | the others | {} |\n", ToString(others));
  std::string of_grades;
  if (root.gravest.failed == 0 && root.rate.failed > 0) {
    of_grades = " All of these are milder than the case above.";
  } else if (root.gravest.failed < root.rate.failed) {
    of_grades = fmt::format(" Of these {} are {}; the others are milder.",
                            root.gravest.failed, NameOf(root.grade));
  }
  const std::string variants =
      root.in_variants == 0
          ? ""
          : fmt::format(
                " A further {} answers are right, or wrong in another way, and "
                "fail with the bodies exchanged, moved, turned or scaled; at least "
                "one of these shows this fault.",
                root.in_variants);
  return fmt::format(
      "## How common\n\n{} of {} answers, {:.3g} %, to all questions that may run into "
      "the same code.{}{} Intervals are those of 95 %.\n\n{}\n",
      root.rate.failed, root.rate.asked, 100 * ShareOf(root.rate), of_grades, variants,
      table);
}

std::string NeighbourhoodPart(const Root& root) {
  const Specimen& smallest = root.smallest();
  std::string text = smallest.is_smallest ? ""
                                          : "## Smaller questions\n\nThe search for a "
                                            "smaller question ended early. There "
                                            "may be one.\n\n";
  if (!smallest.shifts) return text;
  return text +
         fmt::format(
             "## Neighbourhood\n\nThe same fault, by the same measure and proof and "
             "of the same grade, is in {} of {} questions in which B is moved and turned "
             "by 1 % "
             "of the smallest radius or half side.\n\n",
             *smallest.shifts, kShifts);
}

std::string KnownPart(const std::vector<std::string>& known) {
  if (known.empty()) return "## Known\n\nThe ledger of known faults has none like it.\n";
  return fmt::format(
      "## Known\n\nThe ledger has faults of these oracles with these measures and "
      "verdicts; it may be one of them:\n\n- {}\n",
      fmt::join(known, "\n- "));
}

}  // namespace

std::string CaseFile(const Root& root, const std::string& id) {
  const Specimen& smallest = root.smallest();
  const Shrunk shrunk{.question = smallest.question,
                      .finding = smallest.finding,
                      .over = {},
                      .shifts = smallest.shifts};
  return Commented(fmt::format("From {}.", IdOf(smallest.original)), "# ") +
         Commented(Sentence(smallest.finding), "# ") +
         TextOf(Renamed(ScenarioOf(shrunk, smallest.original), id));
}

std::string OriginalFile(const Root& root, const std::string& id) {
  const Question& original = root.smallest().original;
  return Commented(fmt::format("Asked as {}.", IdOf(original)), "# ") +
         TextOf(Renamed(original, id));
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
  return QuestionPart(root, program) + OutputPart(program, output) +
         CausePart(root.smallest().finding) + RatePart(root) + NeighbourhoodPart(root) +
         KnownPart(known);
}

}  // namespace touchstone
