#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "reports/ledger/ledger_file.h"
#include "scenarios/schema/nearest_name.h"

namespace touchstone {
namespace {

constexpr std::array<std::string_view, 11> kKeys = {
    "scenarios", "oracle", "version",  "verdict", "bounds",      "measures",
    "cause",     "reason", "upstream", "expires", "intermittent"};

constexpr std::array kVerdicts = {Verdict::kFail, Verdict::kDisagree, Verdict::kInvalid,
                                  Verdict::kCrashed, Verdict::kTimedOut};

constexpr std::array kCauses = {Cause::kConvention,     Cause::kTie,   Cause::kPrecision,
                                Cause::kDiscretisation, Cause::kModel, Cause::kDefect};

template <typename Values>
std::vector<std::string_view> NamesOf(const Values& values) {
  std::vector<std::string_view> names;
  for (const auto value : values) names.push_back(NameOf(value));
  return names;
}

/** Reads one file and collects its errors. */
class LedgerReader {
 public:
  explicit LedgerReader(const std::filesystem::path& file) : file_(file.string()) {
    ledger_.file = file;
  }

  LedgerResult Read(std::string_view text) && {
    try {
      const toml::table root = toml::parse(text, file_);
      ReadRoot(root);
    } catch (const toml::parse_error& error) {
      Add(error.source(), std::string(error.description()), "valid TOML");
    }
    std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                       return std::tie(a.line, a.column) < std::tie(b.line, b.column);
                     });
    if (!diagnostics_.empty()) return {std::nullopt, std::move(diagnostics_)};
    return {std::move(ledger_), {}};
  }

 private:
  void Add(const toml::source_region& at, std::string what, std::string expected) {
    diagnostics_.push_back({file_, static_cast<int>(at.begin.line),
                            static_cast<int>(at.begin.column), std::move(what),
                            std::move(expected)});
  }

  void ReadRoot(const toml::table& root) {
    for (const auto& [key, node] : root) {
      if (key == "entry") continue;
      Add(key.source(), fmt::format("unknown key \"{}\"", key.str()), "[[entry]] only");
    }
    const toml::node* entries = root.get("entry");
    if (entries == nullptr) return;
    const toml::array* array = entries->as_array();
    if (array == nullptr) {
      Add(entries->source(), "entry is not a list of tables", "[[entry]]");
      return;
    }
    for (const toml::node& node : *array) {
      if (const toml::table* table = node.as_table()) {
        ReadEntry(*table);
      } else {
        Add(node.source(), "an entry is not a table", "[[entry]]");
      }
    }
  }

  void ReadEntry(const toml::table& table) {
    for (const auto& [key, node] : table) {
      if (std::find(kKeys.begin(), kKeys.end(), key.str()) != kKeys.end()) continue;
      const std::string_view nearest = NearestName(key.str(), kKeys);
      Add(key.source(), fmt::format("unknown key \"{}\"", key.str()),
          nearest.empty() ? fmt::format("one of {}", fmt::join(kKeys, ", "))
                          : fmt::format("\"{}\"", nearest));
    }
    LedgerEntry entry;
    entry.line = static_cast<int>(table.source().begin.line);
    entry.scenarios = Text(table, "scenarios", "a glob over scenario ids");
    entry.oracle = Text(table, "oracle", "the name of an oracle");
    entry.version = Text(table, "version", "the library version it was seen in");
    entry.verdict = OneOf(table, "verdict", kVerdicts, Verdict::kFail);
    entry.accepted = WhatIsAccepted(table, entry.verdict);
    entry.cause = OneOf(table, "cause", kCauses, Cause::kDefect);
    entry.reason = Text(table, "reason", "one or two sentences: what goes wrong and why");
    entry.upstream =
        Text(table, "upstream", "a link, an issue \"owner/repo#123\", or \"unreported\"");
    entry.expires = Date(table, "expires");
    entry.intermittent = Intermittent(table);
    ledger_.entries.push_back(std::move(entry));
  }

  /** Returns the node, or nullptr after adding a diagnostic. */
  const toml::node* Required(const toml::table& table, std::string_view key,
                             const std::string& expected) {
    const toml::node* node = table.get(key);
    if (node == nullptr) Add(table.source(), fmt::format("{} is missing", key), expected);
    return node;
  }

  std::string Text(const toml::table& table, std::string_view key,
                   const std::string& expected) {
    const toml::node* node = Required(table, key, expected);
    if (node == nullptr) return "";
    const auto text = node->value_exact<std::string>();
    if (!text) Add(node->source(), fmt::format("{} is not a string", key), expected);
    if (text && text->empty()) {
      Add(node->source(), fmt::format("{} is empty", key), expected);
    }
    return text.value_or("");
  }

  template <typename Values>
  auto Named(const toml::node& node, std::string_view key, const Values& values) {
    using Value = std::decay_t<decltype(*values.begin())>;
    const std::vector<std::string_view> names = NamesOf(values);
    const auto text = node.value_exact<std::string>();
    const auto found = std::find(names.begin(), names.end(), text.value_or(""));
    if (found != names.end()) {
      return std::optional<Value>(*(values.begin() + (found - names.begin())));
    }
    Add(node.source(),
        text ? fmt::format("{} is \"{}\"", key, *text)
             : fmt::format("{} is not a string", key),
        fmt::format("one of {}", fmt::join(names, ", ")));
    return std::optional<Value>();
  }

  template <typename Values, typename Value>
  Value OneOf(const toml::table& table, std::string_view key, const Values& values,
              Value otherwise) {
    const toml::node* node =
        Required(table, key, fmt::format("one of {}", fmt::join(NamesOf(values), ", ")));
    return node == nullptr ? otherwise : Named(*node, key, values).value_or(otherwise);
  }

  std::vector<Accepted> WhatIsAccepted(const toml::table& table, Verdict verdict) {
    const bool has_value = verdict == Verdict::kFail || verdict == Verdict::kDisagree;
    const char* other = has_value ? "measures" : "bounds";
    if (const toml::node* node = table.get(other)) {
      Add(node->source(),
          fmt::format("{} for the verdict \"{}\"", other, NameOf(verdict)),
          has_value ? "bounds" : "measures, since it has no value");
    }
    std::vector<Accepted> accepted = has_value ? Bounds(table) : Measures(table);
    std::sort(accepted.begin(), accepted.end(),
              [](const Accepted& a, const Accepted& b) { return a.measure < b.measure; });
    return accepted;
  }

  std::vector<Accepted> Measures(const toml::table& table) {
    const std::string expected = "a list of measures, e.g. [\"answering\"]";
    std::vector<Accepted> accepted;
    const toml::node* node = Required(table, "measures", expected);
    if (node == nullptr) return accepted;
    const toml::array* array = node->as_array();
    if (array == nullptr || array->empty()) {
      Add(node->source(), "measures names no measure", expected);
      return accepted;
    }
    for (const toml::node& element : *array) {
      const auto measure = Named(element, "measure", AllMeasures());
      if (!measure) continue;
      const bool again =
          std::any_of(accepted.begin(), accepted.end(),
                      [&](const Accepted& of) { return of.measure == *measure; });
      if (again) {
        Add(element.source(), fmt::format("{} is named twice", NameOf(*measure)),
            "each measure once");
      } else {
        accepted.push_back({*measure});
      }
    }
    return accepted;
  }

  std::vector<Accepted> Bounds(const toml::table& table) {
    const std::string expected = "a table of measures, e.g. { separation_error = 0.05 }";
    std::vector<Accepted> accepted;
    const toml::node* node = Required(table, "bounds", expected);
    if (node == nullptr) return accepted;
    const toml::table* bounds = node->as_table();
    if (bounds == nullptr || bounds->empty()) {
      Add(node->source(), "bounds names no measure", expected);
      return accepted;
    }
    for (const auto& [key, value] : *bounds) {
      const std::optional<MeasureKind> measure = MeasureNamed(key.str());
      if (!measure) {
        Add(key.source(), fmt::format("measure is \"{}\"", key.str()),
            fmt::format("one of {}", fmt::join(NamesOf(AllMeasures()), ", ")));
        continue;
      }
      accepted.push_back({*measure, Bound(value, *measure)});
    }
    return accepted;
  }

  double Bound(const toml::node& node, MeasureKind measure) {
    const double bound = node.value<double>().value_or(NAN);
    // A scene that touches exactly is missed by 0 m.
    const bool may_be_zero = measure == MeasureKind::kTouching;
    if (!node.is_number() || !std::isfinite(bound) || bound < 0 ||
        (bound == 0 && !may_be_zero)) {
      Add(node.source(),
          fmt::format("bound of {} is not a {}number", NameOf(measure),
                      may_be_zero ? "" : "positive "),
          fmt::format("a number {} 0, relative to the size of the scene",
                      may_be_zero ? ">=" : ">"));
    }
    if (bound > 1 && IsShare(measure)) {
      Add(node.source(), fmt::format("bound is {}", bound),
          fmt::format("at most 1, which {} cannot exceed", NameOf(measure)));
    }
    return bound;
  }

  bool Intermittent(const toml::table& table) {
    const toml::node* node = table.get("intermittent");
    if (node == nullptr) return false;
    const auto intermittent = node->value_exact<bool>();
    if (!intermittent)
      Add(node->source(), "intermittent is not a boolean", "true or false");
    return intermittent.value_or(false);
  }

  std::string Date(const toml::table& table, std::string_view key) {
    const std::string expected = "a date, e.g. 2026-06-30";
    const toml::node* node = Required(table, key, expected);
    if (node == nullptr) return "";
    const auto date = node->value_exact<toml::date>();
    if (!date) {
      Add(node->source(), fmt::format("{} is not a date", key), expected);
      return "";
    }
    return fmt::format("{:04}-{:02}-{:02}", date->year, date->month, date->day);
  }

  std::string file_;
  Ledger ledger_;
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace

LedgerResult ReadLedger(std::string_view text, const std::filesystem::path& file) {
  return LedgerReader(file).Read(text);
}

LedgerResult ReadLedgerFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    return {std::nullopt, {{file.string(), 1, 1, "cannot be read", "a ledger file"}}};
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return ReadLedger(text.str(), file);
}

}  // namespace touchstone
