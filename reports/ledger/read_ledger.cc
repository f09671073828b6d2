#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "reports/ledger/bounds_file.h"
#include "reports/ledger/ledger_file.h"
#include "scenarios/schema/nearest_name.h"

namespace touchstone {
namespace {

constexpr std::array<std::string_view, 13> kKeys = {
    "scenarios", "oracle",       "version",     "verdict", "measures",
    "cause",     "responsible",  "fault",       "reason",  "upstream",
    "expires",   "intermittent", "beyond_scene"};

constexpr std::array kVerdicts = {Verdict::kFail, Verdict::kDisagree, Verdict::kInvalid,
                                  Verdict::kCrashed, Verdict::kTimedOut};

constexpr std::array kCauses = {Cause::kConvention,     Cause::kTie,   Cause::kPrecision,
                                Cause::kDiscretisation, Cause::kModel, Cause::kSetting,
                                Cause::kDefect};

constexpr std::array kResponsible = {Responsible::kEngine, Responsible::kAdapter,
                                     Responsible::kModel};

template <typename Values>
std::vector<std::string_view> NamesOf(const Values& values) {
  std::vector<std::string_view> names;
  names.reserve(values.size());
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
      if (key == "bounds") {
        Add(key.source(), "bounds are not written here",
            "measures = [...]; `touchstone ledger --update` writes the bounds");
        continue;
      }
      const std::string_view nearest = NearestName(key.str(), kKeys);
      Add(key.source(), fmt::format("unknown key \"{}\"", key.str()),
          nearest.empty() ? fmt::format("one of {}", fmt::join(kKeys, ", "))
                          : fmt::format("\"{}\"", nearest));
    }
    LedgerEntry entry;
    entry.line = static_cast<int>(table.source().begin.line);
    entry.scenarios = Globs(table);
    entry.oracle = Text(table, "oracle", "the name of an oracle");
    entry.version = Text(table, "version", "the library version it was seen in");
    entry.verdict = OneOf(table, "verdict", kVerdicts, Verdict::kFail);
    entry.measures = Measures(table);
    entry.causes = Causes(table);
    entry.responsible = WhoIsResponsible(table);
    if (table.contains("fault")) entry.fault = Sentence(table, "fault");
    entry.reason = Text(table, "reason", "one or two sentences: what goes wrong and why");
    entry.upstream =
        Text(table, "upstream", "a link, an issue \"owner/repo#123\", or \"unreported\"");
    entry.expires = Date(table, "expires");
    entry.intermittent = Flag(table, "intermittent");
    entry.beyond_scene = Flag(table, "beyond_scene");
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

  std::string Sentence(const toml::table& table, std::string_view key) {
    const std::string expected = "one sentence with its stop: what goes wrong";
    std::string text = Text(table, key, expected);
    if (!text.empty() && !text.ends_with('.'))
      Add(table.get(key)->source(), fmt::format("{} has no stop", key), expected);
    return text;
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

  Responsible WhoIsResponsible(const toml::table& table) {
    const toml::node* node = table.get("responsible");
    return node == nullptr
               ? Responsible::kEngine
               : Named(*node, "responsible", kResponsible).value_or(Responsible::kEngine);
  }

  /** Reads a glob or a list of globs. */
  std::vector<std::string> Globs(const toml::table& table) {
    const std::string expected = "a glob over scenario ids, or a list of globs";
    const toml::node* node = Required(table, "scenarios", expected);
    if (node == nullptr) return {};
    std::vector<std::string> globs;
    const auto add = [&](const toml::node& glob) {
      const auto text = glob.value_exact<std::string>();
      if (text && !text->empty()) {
        globs.push_back(*text);
      } else {
        Add(glob.source(),
            text ? "scenarios is empty" : "scenarios is not a string or a list of them",
            expected);
      }
    };
    const toml::array* array = node->as_array();
    if (array == nullptr) {
      add(*node);
    } else if (array->empty()) {
      Add(node->source(), "scenarios is empty", expected);
    } else {
      for (const toml::node& glob : *array) add(glob);
    }
    return globs;
  }

  /** Reads a cause or a list of causes. */
  std::vector<Cause> Causes(const toml::table& table) {
    const std::string expected =
        fmt::format("one of {}", fmt::join(NamesOf(kCauses), ", "));
    const toml::node* node = Required(table, "cause", expected);
    if (node == nullptr) return {};
    const toml::array* array = node->as_array();
    if (array == nullptr) {
      const auto cause = Named(*node, "cause", kCauses);
      return cause ? std::vector{*cause} : std::vector<Cause>();
    }
    if (array->empty()) Add(node->source(), "cause is empty", expected);
    std::vector<Cause> causes;
    for (const toml::node& element : *array) {
      const auto cause = Named(element, "cause", kCauses);
      if (!cause) continue;
      if (std::ranges::find(causes, *cause) != causes.end()) {
        Add(element.source(), fmt::format("{} is named twice", NameOf(*cause)),
            "each cause once");
      } else {
        causes.push_back(*cause);
      }
    }
    return causes;
  }

  std::vector<MeasureKind> Measures(const toml::table& table) {
    const std::string expected = "a list of measures, e.g. [\"separation_error\"]";
    std::vector<MeasureKind> measures;
    const toml::node* node = Required(table, "measures", expected);
    if (node == nullptr) return measures;
    const toml::array* array = node->as_array();
    if (array == nullptr || array->empty()) {
      Add(node->source(), "measures names no measure", expected);
      return measures;
    }
    for (const toml::node& element : *array) {
      const auto measure = Named(element, "measure", AllMeasures());
      if (!measure) continue;
      if (std::ranges::find(measures, *measure) != measures.end()) {
        Add(element.source(), fmt::format("{} is named twice", NameOf(*measure)),
            "each measure once");
      } else {
        measures.push_back(*measure);
      }
    }
    std::ranges::sort(measures);
    return measures;
  }

  bool Flag(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return false;
    const auto flag = node->value_exact<bool>();
    if (!flag)
      Add(node->source(), fmt::format("{} is not a boolean", key), "true or false");
    return flag.value_or(false);
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
  LedgerResult result = ReadLedger(text.str(), file);
  BoundsResult bounds = ReadBoundsFile(BoundsFileOf(file));
  std::move(bounds.diagnostics.begin(), bounds.diagnostics.end(),
            std::back_inserter(result.diagnostics));
  if (result.diagnostics.empty()) {
    result.ledger->bounds = std::move(*bounds.bounds);
  } else {
    result.ledger.reset();
  }
  return result;
}

}  // namespace touchstone
