#include "reports/sweep/sweep_file.h"

#include <array>
#include <cstdlib>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "reports/sweep/finding_names.h"

namespace touchstone {
namespace {

/** "TSwp", the application id in the header of the file. */
constexpr int kApplication = 0x54537770;

constexpr const char* kTables = R"(
CREATE TABLE settings(name TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID;
CREATE TABLE subjects(subject INTEGER PRIMARY KEY, oracle TEXT);
CREATE TABLE series(series INTEGER PRIMARY KEY, kind TEXT, family TEXT, A TEXT, B TEXT,
  seed TEXT, first INTEGER, count INTEGER, climb INTEGER, digest TEXT);
CREATE TABLE blocks(first INTEGER PRIMARY KEY, last INTEGER);
CREATE TABLE questions(series INTEGER, oracle TEXT, asked INTEGER, touching INTEGER,
  undecided INTEGER, verified INTEGER, verified_touching INTEGER,
  PRIMARY KEY(series, oracle)) WITHOUT ROWID;
CREATE TABLE answers(series INTEGER, oracle TEXT, measure TEXT, law TEXT, verdict TEXT,
  grade TEXT, cause TEXT, ending TEXT, touching INTEGER, count INTEGER,
  PRIMARY KEY(series, oracle, measure, law, verdict, grade, cause, ending, touching))
  WITHOUT ROWID;
CREATE TABLE findings(series INTEGER, oracle TEXT, measure TEXT, law TEXT, verdict TEXT,
  grade TEXT, cause TEXT, ending TEXT, touching INTEGER, count INTEGER,
  PRIMARY KEY(series, oracle, measure, law, verdict, grade, cause, ending, touching))
  WITHOUT ROWID;
CREATE TABLE sketches(series INTEGER, oracle TEXT, measure TEXT, law TEXT, bin INTEGER,
  least REAL, count INTEGER,
  PRIMARY KEY(series, oracle, measure, law, bin)) WITHOUT ROWID;
CREATE TABLE worst(series INTEGER, oracle TEXT, measure TEXT, law TEXT, place INTEGER,
  question INTEGER, value REAL, tolerance REAL, tolerances REAL, share REAL, verdict TEXT,
  grade TEXT, PRIMARY KEY(series, oracle, measure, law, place)) WITHOUT ROWID;
CREATE TABLE failures(series INTEGER, oracle TEXT, question INTEGER, measure TEXT,
  law TEXT, verdict TEXT, grade TEXT, cause TEXT, ending TEXT, touching INTEGER,
  value REAL, tolerance REAL, share REAL,
  proof TEXT, scenario TEXT, PRIMARY KEY(series, oracle, question)) WITHOUT ROWID;
)";

/** The tables with rows of a series. */
constexpr std::array<const char*, 6> kTablesOfSeries = {
    "questions", "answers", "findings", "sketches", "worst", "failures"};

void WriteCounts(const Database& database, const char* table, std::size_t series,
                 const std::string& oracle, const FindingCounts& counts) {
  Statement insert(
      database,
      fmt::format("INSERT INTO {} VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", table));
  for (const auto& [kind, count] : counts) {
    insert.Run(series, oracle, NameOf(kind.measure), kind.law, NameOf(kind.verdict),
               NameOf(kind.grade), NameOf(kind.cause), kind.ending,
               std::uint64_t{kind.touching}, count);
  }
}

void WriteOracle(const Database& database, std::size_t series, const std::string& oracle,
                 const OracleTally& tally) {
  Statement(database, "INSERT INTO questions VALUES(?, ?, ?, ?, ?, ?, ?)")
      .Run(series, oracle, tally.asked, tally.touching, tally.undecided, tally.verified,
           tally.verified_touching);
  WriteCounts(database, "answers", series, oracle, tally.answers);
  WriteCounts(database, "findings", series, oracle, tally.findings);
  Statement bins(database, "INSERT INTO sketches VALUES(?, ?, ?, ?, ?, ?, ?)");
  for (const auto& [of, sketch] : tally.sketches) {
    for (const auto& [bin, count] : sketch.bins()) {
      bins.Run(series, oracle, NameOf(of.measure), of.law, bin, Sketch::LeastOf(bin),
               count);
    }
  }
  Statement worst(database,
                  "INSERT INTO worst VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const auto& [of, findings] : tally.worst) {
    std::uint64_t place = 0;
    for (const WorstFinding& finding : findings) {
      worst.Run(series, oracle, NameOf(of.measure), of.law, ++place, finding.question,
                finding.value, finding.tolerance, finding.tolerances, finding.share,
                NameOf(finding.verdict), NameOf(finding.grade));
    }
  }
  Statement failures(
      database,
      "INSERT INTO failures VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const auto& [kind, of_kind] : tally.failures) {
    for (const FailedQuestion& failure : of_kind) {
      failures.Run(series, oracle, failure.question, NameOf(failure.kind.measure),
                   failure.kind.law, NameOf(failure.kind.verdict),
                   NameOf(failure.kind.grade), NameOf(failure.kind.cause),
                   failure.kind.ending, std::uint64_t{failure.kind.touching},
                   failure.value, failure.tolerance, failure.share, failure.proof,
                   failure.scenario);
    }
  }
}

[[noreturn]] void FailOnContents(const Database& database, std::string_view what) {
  throw SweepFileError(
      fmt::format("{}: damaged: {}; expected a file that `touchstone sweep` wrote",
                  database.file().string(), what));
}

/** Returns `value`, which a name in the file stands for. */
template <typename T>
T Known(const Database& database, const std::optional<T>& value,
        const std::string& name) {
  if (!value) FailOnContents(database, fmt::format("the name '{}' is unknown", name));
  return *value;
}

/** Reads a Measurand from two columns, from `column` on. */
Measurand MeasurandAt(const Database& database, const Statement& row, int column) {
  return {Known(database, MeasureNamed(row.Text(column)), row.Text(column)),
          row.Text(column + 1)};
}

/** Reads a FindingKind from seven columns, from `column` on. */
FindingKind KindAt(const Database& database, const Statement& row, int column) {
  const Measurand of = MeasurandAt(database, row, column);
  return {of.measure,
          Known(database, VerdictNamed(row.Text(column + 2)), row.Text(column + 2)),
          Known(database, GradeNamed(row.Text(column + 3)), row.Text(column + 3)),
          Known(database, CauseNamed(row.Text(column + 4)), row.Text(column + 4)),
          of.law,
          row.Text(column + 5),
          row.Integer(column + 6) != 0};
}

FindingCounts ReadCounts(const Database& database, const char* table, std::size_t series,
                         const std::string& oracle) {
  FindingCounts counts;
  Statement row(
      database,
      fmt::format(
          "SELECT measure, law, verdict, grade, cause, ending, touching, count FROM {} "
          "WHERE series = ? AND oracle = ?",
          table));
  row.Start(series, oracle);
  while (row.Next()) counts[KindAt(database, row, 0)] = row.Unsigned(7);
  return counts;
}

OracleTally ReadOracle(const Database& database, std::size_t series,
                       const std::string& oracle) {
  OracleTally tally;
  Statement questions(database,
                      "SELECT asked, touching, undecided, verified, verified_touching "
                      "FROM questions WHERE series = ? AND oracle = ?");
  questions.Start(series, oracle);
  if (questions.Next()) {
    tally.asked = questions.Unsigned(0);
    tally.touching = questions.Unsigned(1);
    tally.undecided = questions.Unsigned(2);
    tally.verified = questions.Unsigned(3);
    tally.verified_touching = questions.Unsigned(4);
  }
  tally.answers = ReadCounts(database, "answers", series, oracle);
  tally.findings = ReadCounts(database, "findings", series, oracle);
  Statement bin(database,
                "SELECT measure, law, bin, count FROM sketches WHERE series = ? AND "
                "oracle = ?");
  bin.Start(series, oracle);
  while (bin.Next()) {
    tally.sketches[MeasurandAt(database, bin, 0)].Add(bin.Integer(2), bin.Unsigned(3));
  }
  Statement worst(database,
                  "SELECT measure, law, question, value, tolerance, tolerances, share, "
                  "verdict, grade FROM worst WHERE series = ? AND oracle = ? "
                  "ORDER BY measure, law, place");
  worst.Start(series, oracle);
  while (worst.Next()) {
    tally.worst[MeasurandAt(database, worst, 0)].push_back(
        {.question = worst.Unsigned(2),
         .value = worst.Real(3),
         .tolerance = worst.Real(4),
         .tolerances = worst.Real(5),
         .share = worst.Real(6),
         .verdict = Known(database, VerdictNamed(worst.Text(7)), worst.Text(7)),
         .grade = Known(database, GradeNamed(worst.Text(8)), worst.Text(8))});
  }
  Statement failure(database,
                    "SELECT question, measure, law, verdict, grade, cause, ending, "
                    "touching, value, tolerance, "
                    "share, proof, scenario FROM failures WHERE series = ? AND "
                    "oracle = ? ORDER BY share DESC, question");
  failure.Start(series, oracle);
  while (failure.Next()) {
    const FindingKind kind = KindAt(database, failure, 1);
    tally.failures[kind].push_back({.question = failure.Unsigned(0),
                                    .kind = kind,
                                    .value = failure.Real(8),
                                    .tolerance = failure.Real(9),
                                    .share = failure.Real(10),
                                    .proof = failure.Text(11),
                                    .scenario = failure.Text(12)});
  }
  return tally;
}

void WriteSeries(Statement& row, std::uint64_t number, const QuestionSeries& series) {
  row.Run(number, "contact", NameOf(series.family), NameOf(series.A), NameOf(series.B),
          fmt::format("{}", series.seed), series.first, series.count, series.climb,
          nullptr);
}

/** The family of questions from a file is the file. Nothing of them is random. */
void WriteSeries(Statement& row, std::uint64_t number, const FileSeries& series) {
  row.Run(number, "file", series.file, NameOf(series.A), NameOf(series.B), nullptr,
          series.first, series.count, nullptr, series.digest);
}

/** A world has no pair of shapes and no search, so their columns are NULL. */
void WriteSeries(Statement& row, std::uint64_t number, const WorldSeries& series) {
  row.Run(number, "world", NameOf(series.family), nullptr, nullptr,
          fmt::format("{}", series.seed), series.first, series.count, nullptr, nullptr);
}

/** Reads a series from the columns kind, family, A, B, seed, first, count, climb, digest.
 */
Series SeriesAt(const Database& database, const Statement& row) {
  const std::string kind = row.Text(0);
  const std::string family = row.Text(1);
  const std::uint64_t seed = std::strtoull(row.Text(4).c_str(), nullptr, 10);
  if (kind == "world") {
    return WorldSeries{.family = Known(database, WorldFamilyNamed(family), family),
                       .seed = seed,
                       .first = row.Unsigned(5),
                       .count = row.Unsigned(6)};
  }
  if (kind == "file") {
    return FileSeries{.file = family,
                      .digest = row.Text(8),
                      .A = Known(database, ShapeKindNamed(row.Text(2)), row.Text(2)),
                      .B = Known(database, ShapeKindNamed(row.Text(3)), row.Text(3)),
                      .first = row.Unsigned(5),
                      .count = row.Unsigned(6)};
  }
  if (kind != "contact")
    FailOnContents(database, fmt::format("the name '{}' is unknown", kind));
  return QuestionSeries{.family = Known(database, FamilyNamed(family), family),
                        .A = Known(database, ShapeKindNamed(row.Text(2)), row.Text(2)),
                        .B = Known(database, ShapeKindNamed(row.Text(3)), row.Text(3)),
                        .seed = seed,
                        .first = row.Unsigned(5),
                        .count = row.Unsigned(6),
                        .climb = row.Unsigned(7)};
}

void WriteSettings(const Database& database, const SweepSettings& settings) {
  Statement value(database, "INSERT INTO settings VALUES(?, ?)");
  for (const auto& [name, text] : settings.values) value.Run(name, text);
  Statement subject(database, "INSERT INTO subjects VALUES(?, ?)");
  std::uint64_t at = 0;
  for (const std::string& name : settings.subjects) subject.Run(at++, name);
  Statement row(database, "INSERT INTO series VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  at = 0;
  for (const Series& series : settings.series) {
    std::visit([&](const auto& of_kind) { WriteSeries(row, at, of_kind); }, series);
    ++at;
  }
}

}  // namespace

SweepFile SweepFile::Create(const std::filesystem::path& file,
                            const SweepSettings& settings, SweepJournal journal) {
  SweepFile result{Database(file, true)};
  const Database& database = result.database_;
  database.Execute("PRAGMA page_size = 4096; PRAGMA encoding = 'UTF-8'");
  database.Execute(journal == SweepJournal::kLog
                       ? "PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = WAL; "
                         "PRAGMA synchronous = NORMAL"
                       : "PRAGMA journal_mode = OFF");
  Transaction transaction(database);
  database.Execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}",
                               kApplication, kSweepSchema));
  database.Execute(kTables);
  WriteSettings(database, settings);
  transaction.Commit();
  result.settings_ = settings;
  return result;
}

SweepFile SweepFile::Resume(const std::filesystem::path& file,
                            const SweepSettings& settings) {
  // A process that was killed while it created the file leaves a database without tables.
  if (!std::filesystem::exists(file) ||
      Database(file, false).Number("SELECT count(*) FROM sqlite_master") == 0) {
    return Create(file, settings, SweepJournal::kLog);
  }
  SweepFile result = Open(file);
  result.Require(settings);
  return result;
}

void SweepFile::Require(const SweepSettings& settings) const {
  if (const auto difference = DifferenceOf(settings_, settings)) {
    throw SweepFileError(
        fmt::format("{}: it belongs to another sweep: {}; expected the same command, or "
                    "another folder",
                    file().string(), *difference));
  }
}

SweepFile SweepFile::Open(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw SweepFileError(
        fmt::format("{}: does not exist; expected a file that `touchstone sweep --out "
                    "DIR` wrote",
                    file.string()));
  }
  SweepFile result{Database(file, false)};
  const Database& database = result.database_;
  database.Execute("PRAGMA locking_mode = EXCLUSIVE; PRAGMA synchronous = NORMAL");
  if (database.Number("PRAGMA application_id") != kApplication) {
    throw SweepFileError(fmt::format(
        "{}: not the file of a sweep; expected one that `touchstone sweep` wrote",
        file.string()));
  }
  const std::int64_t version = database.Number("PRAGMA user_version");
  if (version != kSweepSchema) {
    throw SweepFileError(fmt::format("{}: tables of version {}; expected version {}",
                                     file.string(), version, kSweepSchema));
  }
  const std::string damage = database.Text("PRAGMA quick_check(1)");
  if (damage != "ok") FailOnContents(database, damage);
  result.ReadSettings();
  result.ReadBlocks();
  return result;
}

void SweepFile::ReadSettings() {
  Statement value(database_, "SELECT name, value FROM settings");
  while (value.Next()) settings_.values.emplace(value.Text(0), value.Text(1));
  Statement subject(database_, "SELECT oracle FROM subjects ORDER BY subject");
  while (subject.Next()) settings_.subjects.push_back(subject.Text(0));
  Statement row(
      database_,
      "SELECT kind, family, A, B, seed, first, count, climb, digest FROM series "
      "ORDER BY series");
  while (row.Next()) settings_.series.push_back(SeriesAt(database_, row));
}

void SweepFile::ReadBlocks() {
  Statement row(database_, "SELECT first, last FROM blocks");
  while (row.Next()) {
    if (row.Integer(0) > row.Integer(1) ||
        !blocks_.Add(row.Unsigned(0), row.Unsigned(1))) {
      FailOnContents(database_, "a block is in it twice");
    }
  }
}

SeriesTally SweepFile::Read(std::size_t series) const {
  SeriesTally tally;
  for (const std::string& oracle : settings_.subjects)
    tally.oracles.push_back(ReadOracle(database_, series, oracle));
  return tally;
}

void SweepFile::Commit(const std::map<std::size_t, SeriesTally>& series,
                       const BlockSet& blocks) {
  Transaction transaction(database_);
  for (const auto& [number, tally] : series) {
    for (const char* table : kTablesOfSeries) {
      Statement(database_, fmt::format("DELETE FROM {} WHERE series = ?", table))
          .Run(number);
    }
    for (std::size_t i = 0; i < settings_.subjects.size(); ++i)
      WriteOracle(database_, number, settings_.subjects[i], tally.oracles[i]);
  }
  Statement row(database_, "INSERT INTO blocks VALUES(?, ?)");
  for (const auto& [first, last] : blocks.ranges()) row.Run(first, last);
  transaction.Commit();
  for (const auto& [first, last] : blocks.ranges()) blocks_.Add(first, last);
}

}  // namespace touchstone
