#include "reports/journal/run_journal.h"

#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "oracles/stated_tolerance.h"
#include "oracles/world_setup.h"
#include "reports/journal/examination_wire.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

/** Returns everything about an oracle that its motions depend on, as text. */
std::string IdentityOf(const OracleInfo& oracle) {
  std::string identity =
      fmt::format("{}\n{} {}\n{}\n{}\n", oracle.name, oracle.library, oracle.version,
                  ToString(oracle.tolerance), ToString(oracle.setup, oracle.parameters));
  for (const Setting& setting : oracle.settings)
    identity += fmt::format("{} = {}\n", setting.name, setting.value);
  return identity;
}

std::string IdentityOf(const WorldScenario& scenario) {
  return fmt::format("{}\n{}", scenario.id, WriteScenario(scenario));
}

void Prepare(const Database& database, const std::string& build) {
  database.Execute(
      "PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = WAL; "
      "PRAGMA synchronous = NORMAL");
  Transaction transaction(database);
  database.Execute(
      "CREATE TABLE IF NOT EXISTS build(id TEXT); "
      "CREATE TABLE IF NOT EXISTS worlds(world TEXT, oracle TEXT, result BLOB, "
      "PRIMARY KEY(world, oracle))");
  if (database.Text("SELECT id FROM build") != build) {
    database.Execute("DELETE FROM build; DELETE FROM worlds");
    Statement(database, "INSERT INTO build VALUES(?)").Run(std::string_view(build));
  }
  transaction.Commit();
}

}  // namespace

RunJournal::RunJournal(std::filesystem::path file, const std::string& build)
    : database_(std::in_place, std::move(file), true) {
  Prepare(*database_, build);
}

std::size_t RunJournal::size() const {
  const std::scoped_lock lock(using_);
  return static_cast<std::size_t>(database_->Number("SELECT count(*) FROM worlds"));
}

std::optional<Examination> RunJournal::Find(const WorldScenario& scenario,
                                            const OracleInfo& oracle) const {
  const std::scoped_lock lock(using_);
  Statement row(*database_, "SELECT result FROM worlds WHERE world = ? AND oracle = ?");
  row.Start(std::string_view(IdentityOf(scenario)), std::string_view(IdentityOf(oracle)));
  if (!row.Next()) return std::nullopt;
  return ExaminationFromWire(row.Text(0));
}

void RunJournal::Keep(const WorldScenario& scenario, const OracleInfo& oracle,
                      const Examination& examination) {
  const std::string bytes = ToWire(examination);
  const std::scoped_lock lock(using_);
  Statement(*database_, "INSERT OR REPLACE INTO worlds VALUES(?, ?, ?)")
      .Run(std::string_view(IdentityOf(scenario)), std::string_view(IdentityOf(oracle)),
           std::string_view(bytes));
}

void RunJournal::Clear() {
  const std::scoped_lock lock(using_);
  database_->Execute("DELETE FROM worlds");
}

void RunJournal::Remove() {
  const std::scoped_lock lock(using_);
  const std::filesystem::path file = database_->file();
  database_.reset();
  for (const char* suffix : {"", "-wal", "-shm"}) {
    std::error_code ignored;
    std::filesystem::remove(file.string() + suffix, ignored);
  }
}

}  // namespace touchstone
