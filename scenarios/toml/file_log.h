#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/diagnostic.h"
#include "scenarios/toml/parser.h"
#include "scenarios/validate.h"

namespace touchstone {

/** Collects the diagnostics of one file. */
class FileLog {
 public:
  explicit FileLog(std::string_view file) : file_(file) {}

  void Add(const toml::source_region& at, std::string what, std::string_view expected);

  /** Adds the faults of the contents of `table`, each at the position of its value.
   `prefix` is the path of the table, e.g. "bodies.ball.". */
  void Add(const std::vector<Fault>& faults, const toml::table& table,
           std::string_view prefix);

  /** Adds the error of another file that this one names. */
  void Add(Diagnostic diagnostic) { diagnostics_.push_back(std::move(diagnostic)); }

  /** Adds a note on something that is not an error. */
  void Note(const toml::source_region& at, std::string what);

  const std::vector<Diagnostic>& notes() const { return notes_; }

  /** Returns the number of diagnostics. */
  std::size_t size() const { return diagnostics_.size(); }

  std::vector<Diagnostic> InOrderOfLines() &&;

 private:
  std::string file_;
  std::vector<Diagnostic> diagnostics_;
  std::vector<Diagnostic> notes_;
};

}  // namespace touchstone
