#include "reports/sweep/sweep_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "reports/sweep/climb.h"
#include "reports/sweep/database.h"
#include "reports/sweep/question_id.h"
#include "reports/sweep/read_file_series.h"
#include "reports/sweep/sweep_file.h"
#include "reports/writers/data/data_file.h"
#include "reports/writers/data/json_values.h"
#include "reports/writers/data/texts.h"
#include "reports/writers/read_report_data.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** Failures of one oracle, measure, law, cause and ending whose questions are asked
 * again. */
constexpr int kPerKind = 3;

/** Bins to a factor of ten in a page's histograms. Bins of a sketch, eight to a factor of
 two, fall into them by their least value, which is off by an eighth at most: a ninth of a
 bin. */
constexpr int kBinsPerDecade = 4;

/** Digits of shares and errors. */
constexpr int kDigits = 4;

/** A sweep's file that is read, and what was asked in it. */
struct Opened {
  explicit Opened(const std::filesystem::path& file)
      // Closed at once, since it holds the file exclusively.
      : settings(SweepFile::Open(file).settings()), database(file, false) {}

  /** Returns the series of a row. Throws SweepFileError. */
  const Series& SeriesAt(std::int64_t series) const {
    if (series >= 0 && static_cast<std::size_t>(series) < settings.series.size())
      return settings.series[static_cast<std::size_t>(series)];
    throw SweepFileError(
        fmt::format("{}: damaged: a row belongs to no series; expected a file that "
                    "`touchstone sweep` wrote",
                    database.file().string()));
  }

  SweepSettings settings;
  Database database;
};

/** Failures of all series, the gravest first. */
constexpr const char* kFailures =
    "SELECT oracle, measure, law, verdict, grade, cause, value, share, proof, series, "
    "question, scenario, ending FROM failures "
    "ORDER BY share IS NULL, share DESC, series, oracle, question";

/** Worst findings of all series, those of the most tolerances first. One without an error
 has nothing to see. */
constexpr const char* kWorst =
    "SELECT oracle, measure, law, verdict, value, tolerance, tolerances, share, series, "
    "question, place, grade FROM worst WHERE value <> 0 "
    "ORDER BY tolerances IS NULL, tolerances DESC, share DESC, series, oracle, measure, "
    "law, place";

/** Returns the id of a question in the page. The questions of a worst-case search differ
 from oracle to oracle. */
std::string PageIdOf(const Series& series, std::uint64_t question,
                     const std::string& oracle) {
  return IdOf(series, question) + (IsSearch(series) ? "/" + oracle : "");
}

DataJson Columns(std::initializer_list<const char*> names) {
  DataJson data;
  for (const char* name : names) data[name] = DataJson::array();
  return data;
}

DataJson SettingsData(const Database& database) {
  DataJson settings = DataJson::array();
  Statement row(database, "SELECT name, value FROM settings ORDER BY name");
  row.Start();
  while (row.Next()) settings.push_back({{"name", row.Text(0)}, {"value", row.Text(1)}});
  return settings;
}

/** The names of a sweep's page: columns hold indices into them; "" has the index −1. */
struct PageNames {
  Texts oracles;
  Texts families;
  Texts pairs;  ///< "" for worlds.
  Texts measures;
  Texts laws;  ///< "" for contact questions, and for the measure of having answered.
  Texts verdicts;
  Texts grades;  ///< "" for no fault.
};

/** A pair of shapes in words; '' for worlds, whose shapes are NULL. */
constexpr const char* kPair =
    "coalesce(replace(A, '_', ' ') || '–' || replace(B, '_', ' '), '')";

/** Adds names of what a series asks to a row of `data`. */
void PushSeries(const Series& series, PageNames& names, DataJson& data) {
  std::string pair;
  if (const auto shapes = PairOf(series)) {
    pair = fmt::format("{}–{}", NameOf(shapes->first), NameOf(shapes->second));
    std::ranges::replace(pair, '_', ' ');
  }
  data["family"].push_back(names.families.IndexOf(OriginOf(series)));
  data["pair"].push_back(names.pairs.IndexOf(pair));
}

DataJson AnswersData(const Database& database, PageNames& names) {
  DataJson data = Columns({"family", "pair", "oracle", "verdict", "grade", "count"});
  Statement row(
      database,
      fmt::format("SELECT family, {}, oracle, verdict, grade, sum(answers.count) "
                  "FROM answers JOIN series USING(series) "
                  "GROUP BY family, A, B, oracle, verdict, grade",
                  kPair));
  row.Start();
  while (row.Next()) {
    data["family"].push_back(names.families.IndexOf(row.Text(0)));
    data["pair"].push_back(names.pairs.IndexOf(row.Text(1)));
    data["oracle"].push_back(names.oracles.IndexOf(row.Text(2)));
    data["verdict"].push_back(names.verdicts.IndexOf(row.Text(3)));
    data["grade"].push_back(names.grades.IndexOf(row.Text(4)));
    data["count"].push_back(row.Integer(5));
  }
  return data;
}

/** A histogram of a page. */
struct Histogram {
  std::int64_t zeros = 0;
  std::int64_t infinite = 0;
  std::map<int, std::int64_t> bins;
};

/** Returns the counts of all findings by law and measure. They are summed over the pairs
 of shapes: with them a page of all families would have a row for each of 10^5 counts. */
DataJson FindingCountsData(const Database& database, PageNames& names) {
  DataJson data =
      Columns({"family", "oracle", "measure", "law", "verdict", "grade", "count"});
  Statement row(
      database,
      "SELECT family, oracle, measure, law, verdict, grade, sum(findings.count) "
      "FROM findings JOIN series USING(series) "
      "GROUP BY family, oracle, measure, law, verdict, grade");
  row.Start();
  while (row.Next()) {
    data["family"].push_back(names.families.IndexOf(row.Text(0)));
    data["oracle"].push_back(names.oracles.IndexOf(row.Text(1)));
    data["measure"].push_back(names.measures.IndexOf(row.Text(2)));
    data["law"].push_back(names.laws.IndexOf(row.Text(3)));
    data["verdict"].push_back(names.verdicts.IndexOf(row.Text(4)));
    data["grade"].push_back(names.grades.IndexOf(row.Text(5)));
    data["count"].push_back(row.Integer(6));
  }
  return data;
}

DataJson SketchesData(const Database& database, PageNames& names) {
  std::map<std::array<int, 4>, Histogram> histograms;
  Statement row(database,
                fmt::format("SELECT {}, oracle, measure, law, least, sum(sketches.count) "
                            "FROM sketches JOIN series USING(series) "
                            "GROUP BY A, B, oracle, measure, law, least",
                            kPair));
  row.Start();
  while (row.Next()) {
    Histogram& histogram = histograms[{
        names.pairs.IndexOf(row.Text(0)), names.oracles.IndexOf(row.Text(1)),
        names.measures.IndexOf(row.Text(2)), names.laws.IndexOf(row.Text(3))}];
    const double least = row.Real(4);
    if (least == 0)
      histogram.zeros += row.Integer(5);
    else if (!std::isfinite(least))
      histogram.infinite += row.Integer(5);
    else
      histogram.bins[static_cast<int>(std::floor(kBinsPerDecade * std::log10(least)))] +=
          row.Integer(5);
  }
  DataJson data =
      Columns({"pair", "oracle", "measure", "law", "zeros", "infinite", "bins"});
  for (const auto& [of, histogram] : histograms) {
    data["pair"].push_back(of[0]);
    data["oracle"].push_back(of[1]);
    data["measure"].push_back(of[2]);
    data["law"].push_back(of[3]);
    data["zeros"].push_back(histogram.zeros);
    data["infinite"].push_back(histogram.infinite);
    DataJson bins = DataJson::array();
    for (const auto& [bin, count] : histogram.bins) {
      bins.push_back(bin);
      bins.push_back(count);
    }
    data["bins"].push_back(std::move(bins));
  }
  return data;
}

/** The places of the page's questions by id. */
using Places = std::map<std::string, std::size_t>;

/** The properties by which an entry of the ledger is known: oracle, verdict, measure and
 cause. */
using KnownKind = std::array<std::string, 4>;

/** Returns the kinds that have an entry for the version of an oracle of the page. */
std::set<KnownKind> KnownKindsOf(const Ledger& ledger, const DataJson& oracles) {
  std::set<KnownKind> kinds;
  for (const DataJson& oracle : oracles) {
    for (const LedgerEntry& entry : ledger.entries) {
      if (entry.oracle != oracle["name"] || entry.version != oracle["version"]) continue;
      for (const MeasureKind measure : entry.measures) {
        const auto add = [&](Cause cause) {
          kinds.insert({entry.oracle, std::string(NameOf(entry.verdict)),
                        std::string(NameOf(measure)), std::string(NameOf(cause))});
        };
        std::ranges::for_each(entry.causes, add);
        // A finding of unknown cause may have any.
        add(Cause::kNone);
      }
    }
  }
  return kinds;
}

/** Tells which faults of the page are of no kind that the ledger knows. The run of the
 page had no ledger, so each of them is of one oracle, verdict, measure and cause. */
void MarkNewFaults(const std::set<KnownKind>& known, DataJson& page) {
  const auto name = [&page](const char* column, std::size_t finding) {
    const auto at = page["findings"][column][finding].get<std::size_t>();
    const DataJson& names = page["names"][column];
    return (names[at].is_object() ? names[at]["name"] : names[at]).get<std::string>();
  };
  for (DataJson& cluster : page["clusters"]) {
    const auto worst = cluster["worst"].get<std::size_t>();
    const auto oracle = page["findings"]["oracle"][worst].get<std::size_t>();
    cluster["is_new"] =
        !known.contains({page["oracles"][oracle]["name"], name("verdict", worst),
                         name("measure", worst), name("cause", worst)});
  }
}

/** A question of a row that was asked again for the page. */
struct Asked {
  std::size_t place;  ///< In the questions of the page.
  const Series& series;
};

/** Returns the question of a row: its oracle is column 0, its series `series`, and its
 index the next column; nothing if it was not asked again. */
std::optional<Asked> AskedOf(const Statement& row, int series, const Opened& sweep,
                             const Places& places) {
  const Series& of = sweep.SeriesAt(row.Integer(series));
  const auto place = places.find(PageIdOf(of, row.Unsigned(series + 1), row.Text(0)));
  if (place == places.end()) return std::nullopt;
  return Asked{place->second, of};
}

/** Appends what failures and worst findings have in common: the question, its family and
 pair, and the names in columns 0 to 3. */
void PushFinding(const Asked& asked, const Statement& row, PageNames& names,
                 DataJson& data) {
  data["question"].push_back(asked.place);
  PushSeries(asked.series, names, data);
  data["oracle"].push_back(names.oracles.IndexOf(row.Text(0)));
  data["measure"].push_back(names.measures.IndexOf(row.Text(1)));
  data["law"].push_back(names.laws.IndexOf(row.Text(2)));
  data["verdict"].push_back(names.verdicts.IndexOf(row.Text(3)));
}

DataJson FailuresData(const Opened& sweep, const Places& places,
                      const std::set<KnownKind>& known, PageNames& names) {
  DataJson data = Columns({"question", "family", "pair", "oracle", "measure", "law",
                           "verdict", "grade", "value", "share", "proof", "is_new"});
  Statement row(sweep.database, kFailures);
  row.Start();
  while (row.Next()) {
    const std::optional<Asked> asked = AskedOf(row, 9, sweep, places);
    if (!asked) continue;
    PushFinding(*asked, row, names, data);
    data["grade"].push_back(names.grades.IndexOf(row.Text(4)));
    data["value"].push_back(ToData(row.Real(6), kDigits));
    data["share"].push_back(ToShare(row.Real(7)));
    data["proof"].push_back(row.Text(8));
    data["is_new"].push_back(
        !known.contains({row.Text(0), row.Text(3), row.Text(1), row.Text(5)}));
  }
  return data;
}

DataJson WorstData(const Opened& sweep, const Places& places, PageNames& names) {
  DataJson data =
      Columns({"question", "family", "pair", "oracle", "measure", "law", "verdict",
               "grade", "value", "tolerance", "tolerances", "share"});
  Statement row(sweep.database, kWorst);
  row.Start();
  while (row.Next()) {
    const std::optional<Asked> asked = AskedOf(row, 8, sweep, places);
    if (!asked) continue;
    PushFinding(*asked, row, names, data);
    data["grade"].push_back(names.grades.IndexOf(row.Text(11)));
    data["value"].push_back(ToData(row.Real(4), kDigits));
    data["tolerance"].push_back(ToData(row.Real(5), kDigits));
    data["tolerances"].push_back(ToData(row.Real(6), kDigits));
    data["share"].push_back(ToShare(row.Real(7)));
  }
  return data;
}

DataJson SweepData(const Opened& sweep, const std::set<KnownKind>& known,
                   const DataJson& questions) {
  const Database& database = sweep.database;
  Places places;
  for (std::size_t q = 0; q < questions.size(); ++q)
    places[questions[q]["id"].get<std::string>()] = q;
  PageNames names;
  for (const std::string& subject : sweep.settings.subjects)
    names.oracles.IndexOf(subject);
  DataJson data;
  const std::vector<Series>& series = sweep.settings.series;
  data["kind"] = series.empty() ? "contact" : KindNameOf(series.front());
  data["settings"] = SettingsData(database);
  data["asked"] = database.Number("SELECT sum(count) FROM series");
  data["failed"] = database.Number(
      "SELECT sum(count) FROM answers WHERE verdict IN ('fail', 'disagree', 'crashed', "
      "'timed out', 'invalid')");
  data["kept"] = database.Number("SELECT count(*) FROM failures");
  data["answers"] = AnswersData(database, names);
  data["findings"] = FindingCountsData(database, names);
  data["bins_per_decade"] = kBinsPerDecade;
  data["sketches"] = SketchesData(database, names);
  data["failures"] = FailuresData(sweep, places, known, names);
  data["worst"] = WorstData(sweep, places, names);
  data["names"] = {{"oracle", names.oracles.all()}, {"family", names.families.all()},
                   {"pair", names.pairs.all()},     {"measure", names.measures.all()},
                   {"law", names.laws.all()},       {"verdict", names.verdicts.all()},
                   {"grade", names.grades.all()}};
  return data;
}

/** Questions by the ids that they have in the page. */
class Collected {
 public:
  explicit Collected(const std::string& file) : file_(file) {}

  std::size_t size() const { return contacts_.size() + worlds_.size(); }
  bool Has(const std::string& id) const {
    return contacts_.contains(id) || worlds_.contains(id);
  }

  /** Adds the question of a failure, a scenario file. Throws SweepFileError. */
  void Add(const std::string& id, const std::string& toml) {
    ReadResult read = ReadScenario(toml, file_);
    if (!read.scenario && !read.world) {
      throw SweepFileError(fmt::format(
          "{}: damaged: a question cannot be read; expected a file that `touchstone "
          "sweep` wrote",
          file_));
    }
    if (read.world)
      Add(id, std::move(*read.world));
    else
      Add(id, std::move(*read.scenario));
  }
  void Add(const std::string& id, Scenario scenario) {
    scenario.id = id;
    contacts_.emplace(id, std::move(scenario));
  }
  void Add(const std::string& id, WorldScenario scenario) {
    scenario.id = id;
    worlds_.emplace(id, std::move(scenario));
  }

  Questions Take() && {
    Questions questions;
    for (auto& [id, question] : contacts_)
      questions.contacts.push_back(std::move(question));
    for (auto& [id, question] : worlds_) questions.worlds.push_back(std::move(question));
    return questions;
  }

 private:
  std::string file_;
  std::map<std::string, Scenario> contacts_;
  std::map<std::string, WorldScenario> worlds_;
};

/** The files from which a sweep has questions, read again. */
class FilesAgain {
 public:
  /** Returns a question; empty if its file is no longer there, or has changed. */
  std::optional<Scenario> QuestionAt(const FileSeries& series, std::uint64_t index) {
    auto file = files_.find(series.file);
    if (file == files_.end())
      file = files_.emplace(series.file, ReadFileSeries(series.file)).first;
    for (const FileSeries& again : file->second.series) {
      const bool is_same =
          again.digest == series.digest && again.A == series.A && again.B == series.B;
      if (is_same && index < again.count) return ScenarioAt(again, index);
    }
    return std::nullopt;
  }

 private:
  std::map<std::string, FileOfQuestions> files_;
};

/** Adds question `index` of a series, as `subject` was asked it, to `to`. Adds nothing if
 it is from a file that is no longer there. */
void AddQuestion(const std::string& id, const Series& series, std::uint64_t index,
                 const Oracle& subject, FilesAgain& files, Collected& to) {
  if (const auto* file = std::get_if<FileSeries>(&series)) {
    if (std::optional<Scenario> question = files.QuestionAt(*file, index))
      to.Add(id, std::move(*question));
    return;
  }
  if (const auto* worlds = std::get_if<WorldSeries>(&series)) {
    to.Add(id, WorldAt(*worlds, index));
    return;
  }
  QuestionSeries one = std::get<QuestionSeries>(series);
  one.first = index;
  one.count = 1;
  to.Add(id, one.climb > 1 ? std::move(ClimbOf(one, subject).scenarios.front())
                           : ScenarioAt(one, index));
}

/** Adds the failures that are number `place` of their kind by gravity. */
void AddFailures(const Opened& sweep, int place, std::size_t limit, Collected& kept) {
  std::map<std::array<std::string, 5>, int> of_kind;
  Statement row(sweep.database, kFailures);
  row.Start();
  while (kept.size() < limit && row.Next()) {
    if (++of_kind[{row.Text(0), row.Text(1), row.Text(2), row.Text(5), row.Text(12)}] !=
        place) {
      continue;
    }
    const Series& series = sweep.SeriesAt(row.Integer(9));
    kept.Add(PageIdOf(series, row.Unsigned(10), row.Text(0)), row.Text(11));
  }
}

}  // namespace

KeptQuestions ReadKeptQuestions(
    const std::filesystem::path& file, const KeptLimits& limits,
    const std::function<const Oracle&(const std::string&)>& oracle_named) {
  const Opened sweep(file);
  const std::vector<Series>& all = sweep.settings.series;
  const bool is_of_worlds = !all.empty() && IsOfWorlds(all.front());
  const std::size_t limit = is_of_worlds ? limits.worlds : limits.contacts;
  Collected kept(file.string());
  for (int place = 1; place <= kPerKind; ++place) AddFailures(sweep, place, limit, kept);
  const std::size_t most = kept.size() + limit;
  std::set<std::array<std::string, 3>> measured;
  FilesAgain files;
  Statement worst(sweep.database, kWorst);
  worst.Start();
  while (kept.size() < most && worst.Next()) {
    const std::string oracle = worst.Text(0);
    if (!measured.insert({oracle, worst.Text(1), worst.Text(2)}).second) continue;
    const Series& series = sweep.SeriesAt(worst.Integer(8));
    const std::uint64_t question = worst.Unsigned(9);
    const std::string id = PageIdOf(series, question, oracle);
    if (!kept.Has(id))
      AddQuestion(id, series, question, oracle_named(oracle), files, kept);
  }
  return {sweep.settings.subjects, std::move(kept).Take()};
}

std::string WithSweep(const std::string& data, const std::filesystem::path& file,
                      const Ledger& ledger) {
  DataFile page = UnpackData(data, std::numeric_limits<std::size_t>::max()).file.value();
  const std::set<KnownKind> known = KnownKindsOf(ledger, page.json["oracles"]);
  MarkNewFaults(known, page.json);
  for (DataJson& question : page.json["questions"]) {
    if (!QuestionOfId(question["id"].get<std::string>())) question["own"] = true;
  }
  page.json["sweep"] = SweepData(Opened(file), known, page.json["questions"]);
  return PackData(page);
}

}  // namespace touchstone
