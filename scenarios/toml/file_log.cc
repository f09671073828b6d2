#include "scenarios/toml/file_log.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace touchstone {

void FileLog::Add(const toml::source_region& at, std::string what,
                  std::string_view expected) {
  diagnostics_.push_back({file_, static_cast<int>(at.begin.line),
                          static_cast<int>(at.begin.column), std::move(what),
                          std::string(expected)});
}

void FileLog::Note(const toml::source_region& at, std::string what) {
  notes_.push_back({file_, static_cast<int>(at.begin.line),
                    static_cast<int>(at.begin.column), std::move(what), ""});
}

void FileLog::Add(const std::vector<Fault>& faults, const toml::table& table,
                  std::string_view prefix) {
  for (const Fault& fault : faults) {
    const toml::node_view<const toml::node> node = toml::at_path(table, fault.where);
    Add(node ? node.node()->source() : table.source(),
        fmt::format("{}{} {}", prefix, fault.where, fault.what), fault.expected);
  }
}

std::vector<Diagnostic> FileLog::InOrderOfLines() && {
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return std::tie(a.line, a.column) < std::tie(b.line, b.column);
                   });
  return std::move(diagnostics_);
}

}  // namespace touchstone
