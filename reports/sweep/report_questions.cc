#include "reports/sweep/report_questions.h"

#include <fstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

using Json = nlohmann::json;

/** Returns `key = value` as TOML: lists, numbers and strings are written as in JSON. */
std::string Entry(const char* key, const Json& value) {
  return fmt::format("{} = {}\n", key, value.dump());
}

/** Returns the table of a body in a scenario file. Throws Json::exception. */
std::string BodyText(const Json& body) {
  std::string text = Entry("shape", body.at("shape"));
  for (const char* size :
       {"radius", "half_extents", "half_length", "half_height", "vertices"}) {
    if (body.contains(size)) text += Entry(size, body.at(size));
  }
  text += Entry("position", body.at("position"));
  // The report has the matrix of a quaternion too.
  const bool has_quaternion = body.contains("quaternion_wxyz");
  return text + (has_quaternion ? Entry("quaternion", body.at("quaternion_wxyz"))
                                : Entry("rotation", body.at("rotation")));
}

/** Returns the table of the tolerance that its author grants; empty if there is none.
 Throws Json::exception. */
std::string ToleranceText(const Json& question) {
  if (!question.contains("tolerance")) return "";
  const Json& tolerance = question.at("tolerance");
  return "[tolerance]\n" + Entry("separation", tolerance.at("separation")) +
         Entry("because", tolerance.at("because"));
}

/** Returns a question of the report as the text of a scenario file, whose reader knows
 what is valid. Throws Json::exception. */
std::string ScenarioText(const Json& question) {
  return Entry("id", question.at("id")) + Entry("title", question.at("title")) +
         Entry("source", question.at("source")) + "[bodies.A]\n" +
         BodyText(question.at("A")) + "[bodies.B]\n" + BodyText(question.at("B")) +
         "[contact]\nA = \"A\"\nB = \"B\"\n" + ToleranceText(question);
}

/** Adds the question of a line, if it has one. Returns its error. */
std::optional<Diagnostic> AddQuestion(const std::string& line, const std::string& file,
                                      int number, std::vector<Scenario>& to) try {
  const Json json = Json::parse(line);
  if (json.at("kind") != "scenario") return std::nullopt;
  ReadResult read = ReadScenario(ScenarioText(json), file);
  if (read.scenario) {
    to.push_back(std::move(*read.scenario));
    to.back().places = {};  // They are in a text that nobody has.
    return std::nullopt;
  }
  const Diagnostic& first = read.diagnostics.front();
  return Diagnostic{file, number, 1, first.what, first.expected};
} catch (const Json::exception&) {
  return Diagnostic{file, number, 1, "is no line of a report",
                    "a report.jsonl that `touchstone run --out` wrote"};
}

}  // namespace

ReportQuestions ReadReportQuestions(const std::filesystem::path& file) {
  const std::string name = file.generic_string();
  std::ifstream in(file);
  ReportQuestions read;
  std::string line;
  for (int number = 1; !read.error && std::getline(in, line); ++number)
    read.error = AddQuestion(line, name, number, read.scenarios);
  if (!read.error && read.scenarios.empty()) {
    read.error = Diagnostic{name, 0, 0, "has no contact question",
                            "a report.jsonl that `touchstone run --out` wrote"};
  }
  if (read.error) read.scenarios.clear();
  return read;
}

}  // namespace touchstone
