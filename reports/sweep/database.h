#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace touchstone {

/** An error of a sweep's file, as one line for the user: "FILE: what; expected what". */
class SweepFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** An SQLite database. Every function throws SweepFileError on failure. */
class Database {
 public:
  /** Opens `file`. If `create`, creates it if it does not exist; ":memory:" is a database
   in memory. */
  Database(std::filesystem::path file, bool create);

  const std::filesystem::path& file() const { return file_; }

  /** Executes statements that return no rows. */
  void Execute(const std::string& sql) const;

  /** Returns the first column of the first row as a number. */
  std::int64_t Number(const std::string& sql) const;

  /** Returns the first column of the first row as text. */
  std::string Text(const std::string& sql) const;

  sqlite3* get() const { return database_.get(); }

  /** Throws the error of the last call. */
  [[noreturn]] void Fail() const;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> database_;
};

/** A prepared statement. Parameters and columns are counted from 0. */
class Statement {
 public:
  Statement(const Database& database, std::string_view sql);

  /** Binds the parameters in order and executes a statement that returns no rows. */
  template <typename... Values>
  void Run(const Values&... values) {
    Start(values...);
    while (Next()) {
    }
  }

  /** Binds the parameters in order; Next() then returns the rows. */
  template <typename... Values>
  void Start(const Values&... values) {
    Reset();
    int at = 0;
    (Bind(at++, values), ...);
  }

  /** Moves to the next row; returns false if there is none. */
  bool Next();

  std::int64_t Integer(int column) const;
  std::uint64_t Unsigned(int column) const {
    return static_cast<std::uint64_t>(Integer(column));
  }
  /** NULL is NaN, which SQLite does not have. */
  double Real(int column) const;
  std::string Text(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  void Reset();
  void Bind(int at, std::int64_t value);
  void Bind(int at, std::uint64_t value) { Bind(at, static_cast<std::int64_t>(value)); }
  void Bind(int at, double value);
  void Bind(int at, std::string_view value);
  /** Binds NULL. */
  void Bind(int at, std::nullptr_t);

  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/** A transaction, which is rolled back unless it is committed. */
class Transaction {
 public:
  explicit Transaction(const Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void Commit();

 private:
  const Database& database_;
  bool open_ = true;
};

}  // namespace touchstone
