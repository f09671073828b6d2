#include "reports/sweep/read_file_series.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "reports/sweep/report_questions.h"
#include "reports/text/counted.h"
#include "scenarios/contact_table.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** A file's questions before they are divided by pair. */
struct ReadQuestions {
  std::vector<Scenario> scenarios;
  std::vector<Diagnostic> errors = {};
  std::vector<Diagnostic> notes = {};
};

ReadQuestions QuestionsInTable(const std::string& file) {
  ContactTable table = ReadContactTableFile(file);
  ReadQuestions read{.scenarios = std::move(table.scenarios),
                     .errors = std::move(table.errors)};
  if (table.note) read.notes.push_back(std::move(*table.note));
  return read;
}

ReadQuestions QuestionsInReport(const std::string& file) {
  ReportQuestions report = ReadReportQuestions(file);
  ReadQuestions read{.scenarios = std::move(report.scenarios)};
  if (report.error) read.errors.push_back(std::move(*report.error));
  return read;
}

ReadQuestions QuestionsInScenarioFiles(const std::string& file) {
  Catalogue catalogue = ReadCatalogue(std::filesystem::path(file));
  ReadQuestions read{.scenarios = std::move(catalogue.scenarios),
                     .errors = std::move(catalogue.diagnostics),
                     .notes = std::move(catalogue.notes)};
  if (!read.errors.empty()) return read;
  if (read.scenarios.empty()) {
    read.errors.push_back(
        {file, 0, 0, "has no contact question",
         "a scenario with [contact]; of a folder, its tables (*.csv) are not read"});
  } else if (!catalogue.worlds.empty()) {
    read.notes.push_back(
        {file, 0, 0,
         Counted(catalogue.worlds.size(), "world is left out", "worlds are left out"),
         ""});
  }
  return read;
}

/** Returns the questions in a file, whose kind its extension tells. */
ReadQuestions QuestionsIn(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (extension == ".csv") return QuestionsInTable(file);
  if (extension == ".jsonl") return QuestionsInReport(file);
  std::error_code error;
  if (extension == ".toml" || !std::filesystem::is_regular_file(file, error))
    return QuestionsInScenarioFiles(file);
  return {.scenarios = {},
          .errors = {{file, 0, 0, "has an unknown extension",
                      ".csv, .jsonl or .toml, or a folder of scenario files"}}};
}

}  // namespace

FileOfQuestions ReadFileSeries(const std::string& file) {
  ReadQuestions read = QuestionsIn(file);
  FileOfQuestions result{
      .series = {}, .errors = std::move(read.errors), .notes = std::move(read.notes)};
  if (!result.errors.empty()) return result;
  const std::string digest = DigestOf(read.scenarios);
  std::vector<std::vector<Scenario>> questions;
  for (Scenario& scenario : read.scenarios) {
    const ShapeKind A = KindOf(scenario.contact.A.shape);
    const ShapeKind B = KindOf(scenario.contact.B.shape);
    const auto found = std::ranges::find_if(
        result.series, [&](const FileSeries& s) { return s.A == A && s.B == B; });
    const auto at = static_cast<std::size_t>(found - result.series.begin());
    if (found == result.series.end()) {
      result.series.push_back({.file = file, .digest = digest, .A = A, .B = B});
      questions.emplace_back();
    }
    questions[at].push_back(std::move(scenario));
  }
  for (std::size_t i = 0; i < questions.size(); ++i) {
    result.series[i].count = questions[i].size();
    result.series[i].questions =
        std::make_shared<const std::vector<Scenario>>(std::move(questions[i]));
  }
  return result;
}

}  // namespace touchstone
