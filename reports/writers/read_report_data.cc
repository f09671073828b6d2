#include "reports/writers/read_report_data.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "reports/writers/data/data_file.h"
#include "reports/writers/data/json_values.h"

namespace touchstone {
namespace {

constexpr const char* kExpected =
    "report.data of `touchstone run --out DIR`, or that folder";

/** A reason why bytes are no report data. */
struct Refused {
  std::string what;
};

/** Returns the element of that name and type. Throws Refused. */
const DataJson& At(const DataJson& json, const char* name, DataJson::value_t type) {
  const auto found = json.is_object() ? json.find(name) : json.end();
  if (!json.is_object() || found == json.end() || found->type() != type)
    throw Refused{fmt::format("has no valid `{}`", name)};
  return *found;
}

const DataJson& ArrayAt(const DataJson& json, const char* name) {
  return At(json, name, DataJson::value_t::array);
}

std::string TextAt(const DataJson& json, const char* name) {
  return At(json, name, DataJson::value_t::string).get<std::string>();
}

/** Returns an index below `end`. Throws Refused. */
std::size_t Index(const DataJson& json, std::size_t end, const char* of) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() >= end)
    throw Refused{fmt::format("refers to a {} that it does not have", of)};
  return json.get<std::size_t>();
}

/** Returns a number that ToData() has written. Throws Refused. */
double Number(const DataJson& json) {
  if (json.is_number()) return json.get<double>();
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return std::numeric_limits<double>::infinity();
  if (json == "-inf") return -std::numeric_limits<double>::infinity();
  throw Refused{"has a text in place of a number"};
}

/** The values that indices of a column stand for, by the names that the file gives them.
 */
template <typename Value, typename Named>
std::vector<Value> Values(const DataJson& names, Named named, const char* of) {
  std::vector<Value> values;
  for (const DataJson& name : names) {
    const DataJson& text =
        name.is_object() && name.contains("name") ? name["name"] : name;
    const std::optional<Value> value =
        text.is_string() ? named(text.get<std::string>()) : std::nullopt;
    if (!value)
      throw Refused{fmt::format("names a {} that this program does not know", of)};
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> NamesIn(const DataJson& list, const char* key) {
  std::vector<std::string> names;
  for (const DataJson& element : list) names.push_back(TextAt(element, key));
  return names;
}

/** Returns the findings. Throws Refused. */
Baseline FindingsIn(const DataJson& json) {
  const DataJson& questions = ArrayAt(json, "questions");
  const std::vector<std::string> ids = NamesIn(questions, "id");
  const std::vector<std::string> oracles = NamesIn(ArrayAt(json, "oracles"), "name");
  const DataJson& texts = ArrayAt(json, "texts");
  const DataJson& names = At(json, "names", DataJson::value_t::object);
  const std::vector<MeasureKind> measures = Values<MeasureKind>(
      ArrayAt(names, "measure"), [](const std::string& n) { return MeasureNamed(n); },
      "measure");
  const std::vector<Verdict> verdicts =
      Values<Verdict>(ArrayAt(names, "verdict"), VerdictNamed, "verdict");
  const DataJson& columns = At(json, "findings", DataJson::value_t::object);
  const DataJson& question = ArrayAt(columns, "question");
  const auto column = [&](const char* name) -> const DataJson& {
    const DataJson& values = ArrayAt(columns, name);
    if (values.size() != question.size())
      throw Refused{fmt::format("has no whole column `{}`", name)};
    return values;
  };
  const DataJson& oracle = column("oracle");
  const DataJson& measure = column("measure");
  const DataJson& verdict = column("verdict");
  const DataJson& law = column("law");
  const DataJson& value = column("value");
  const DataJson& tolerance = column("tolerance");
  Baseline baseline;
  for (std::size_t f = 0; f < question.size(); ++f) {
    const std::size_t q = Index(question[f], ids.size(), "question");
    const std::size_t o = Index(oracle[f], oracles.size(), "oracle");
    LedgerCell cell{ids[q], oracles[o],
                    measures[Index(measure[f], measures.size(), "measure")], ""};
    if (law[f] != -1) {
      const DataJson& text = texts[Index(law[f], texts.size(), "text")];
      if (!text.is_string()) throw Refused{"has a text that is none"};
      cell.law = text.get<std::string>();
    }
    const DataJson& roundings = ArrayAt(questions[q], "rounding");
    if (roundings.size() != oracles.size()) throw Refused{"has no whole list `rounding`"};
    const double rounding = Number(roundings[o]);
    baseline.Add(cell,
                 {.value = Number(value[f]),
                  .verdict = verdicts[Index(verdict[f], verdicts.size(), "verdict")],
                  .floor = FloorOf(cell.measure, Number(tolerance[f]), rounding)});
  }
  return baseline;
}

/** Returns the oracles; an old report may lack their versions. Throws Refused. */
std::vector<ReadOracle> OraclesIn(const DataJson& json) {
  std::vector<ReadOracle> oracles;
  for (const DataJson& oracle : ArrayAt(json, "oracles")) {
    oracles.push_back({TextAt(oracle, "name"), oracle.contains("version")
                                                   ? TextAt(oracle, "version")
                                                   : std::string()});
  }
  return oracles;
}

/** Returns the texts of the questions that have one, by their ids. Throws Refused. */
std::map<std::string, std::string> QuestionsIn(const DataJson& json) {
  std::map<std::string, std::string> questions;
  for (const DataJson& question : ArrayAt(json, "questions")) {
    if (question.contains("toml"))
      questions.emplace(TextAt(question, "id"), TextAt(question, "toml"));
  }
  return questions;
}

ReadReportResult Error(const std::filesystem::path& file, std::string what) {
  return {std::nullopt, {{file.string(), 1, 1, std::move(what), kExpected}}};
}

}  // namespace

ReadReportResult ReadReport(std::string bytes, const std::filesystem::path& file,
                            std::size_t most) {
  const Unpacked unpacked = UnpackData(bytes, most);
  if (!unpacked.file) return Error(file, unpacked.fault);
  try {
    const DataJson& json = unpacked.file->json;
    ReadReportData data{.baseline = FindingsIn(json),
                        .questions = QuestionsIn(json),
                        .oracles = OraclesIn(json),
                        .command = TextAt(json, "command"),
                        .bytes = std::move(bytes)};
    return {std::move(data), {}};
  } catch (const Refused& refused) {
    return Error(file, refused.what);
  }
}

ReadReportResult ReadReportFile(const std::filesystem::path& file_or_folder) {
  std::error_code error;
  const std::filesystem::path file = std::filesystem::is_directory(file_or_folder, error)
                                         ? file_or_folder / "report.data"
                                         : file_or_folder;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) return Error(file, "cannot be read");
  return ReadReport(std::move(text).str(), file);
}

}  // namespace touchstone
