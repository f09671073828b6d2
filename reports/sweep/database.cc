#include "reports/sweep/database.h"

#include <limits>
#include <utility>

#include <fmt/format.h>
#include <sqlite3.h>

namespace touchstone {

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close(database);
}

Database::Database(std::filesystem::path file, bool create) : file_(std::move(file)) {
  sqlite3* database = nullptr;
  const int flags = SQLITE_OPEN_READWRITE | (create ? SQLITE_OPEN_CREATE : 0);
  const int code = sqlite3_open_v2(file_.c_str(), &database, flags, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) Fail();
  // Another process may read the file for a moment, such as one that shows its progress.
  sqlite3_busy_timeout(database, 2000);
}

void Database::Fail() const {
  const int code = sqlite3_errcode(get());
  if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
    throw SweepFileError(fmt::format(
        "{}: another process has the file open; expected one process per file",
        file_.string()));
  }
  if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT || code == SQLITE_ERROR) {
    throw SweepFileError(
        fmt::format("{}: damaged, or not the file of a sweep or a run ({}); "
                    "expected one that touchstone wrote, or none: remove it",
                    file_.string(), sqlite3_errmsg(get())));
  }
  throw SweepFileError(fmt::format("{}: {}; expected a file that can be read and written",
                                   file_.string(), sqlite3_errmsg(get())));
}

void Database::Execute(const std::string& sql) const {
  if (sqlite3_exec(get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) Fail();
}

std::int64_t Database::Number(const std::string& sql) const {
  Statement statement(*this, sql);
  return statement.Next() ? statement.Integer(0) : 0;
}

std::string Database::Text(const std::string& sql) const {
  Statement statement(*this, sql);
  return statement.Next() ? statement.Text(0) : "";
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Statement::Statement(const Database& database, std::string_view sql)
    : database_(database) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database.get(), sql.data(), static_cast<int>(sql.size()),
                         &statement, nullptr) != SQLITE_OK) {
    database.Fail();
  }
  statement_.reset(statement);
}

void Statement::Reset() {
  sqlite3_reset(statement_.get());
}

bool Statement::Next() {
  switch (sqlite3_step(statement_.get())) {
    case SQLITE_ROW:
      return true;
    case SQLITE_DONE:
      return false;
    default:
      database_.Fail();
  }
}

std::int64_t Statement::Integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::Real(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL
             ? std::numeric_limits<double>::quiet_NaN()
             : sqlite3_column_double(statement_.get(), column);
}

std::string Statement::Text(int column) const {
  const void* const text = sqlite3_column_blob(statement_.get(), column);
  const auto size =
      static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return text == nullptr ? "" : std::string(static_cast<const char*>(text), size);
}

void Statement::Bind(int at, std::int64_t value) {
  if (sqlite3_bind_int64(statement_.get(), at + 1, value) != SQLITE_OK) database_.Fail();
}

void Statement::Bind(int at, double value) {
  if (sqlite3_bind_double(statement_.get(), at + 1, value) != SQLITE_OK) database_.Fail();
}

void Statement::Bind(int at, std::string_view value) {
  // SQLITE_TRANSIENT, a cast in SQLite's header, makes SQLite copy the text.
  if (sqlite3_bind_text64(statement_.get(), at + 1, value.data(), value.size(),
                          SQLITE_TRANSIENT, SQLITE_UTF8) != SQLITE_OK) {
    database_.Fail();
  }
}

void Statement::Bind(int at, std::nullptr_t) {
  if (sqlite3_bind_null(statement_.get(), at + 1) != SQLITE_OK) database_.Fail();
}

Transaction::Transaction(const Database& database) : database_(database) {
  database_.Execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (open_) sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::Commit() {
  database_.Execute("COMMIT");
  open_ = false;
}

}  // namespace touchstone
