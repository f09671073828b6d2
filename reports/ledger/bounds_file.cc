#include "reports/ledger/bounds_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "scenarios/validate_scenario.h"

namespace touchstone {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/** The verdicts without a value, with their names in a file of bounds. */
constexpr auto kWithoutValue = std::to_array<std::pair<Verdict, std::string_view>>(
    {{Verdict::kInvalid, "invalid"},
     {Verdict::kCrashed, "crashed"},
     {Verdict::kTimedOut, "timed_out"}});

bool IsEscaped(char c) {
  return static_cast<unsigned char>(c) <= ' ' || c == '%' || c == '#' || c == 0x7f;
}

std::string Escaped(std::string_view name) {
  std::string text;
  for (const char c : name) {
    text += IsEscaped(c) ? fmt::format("%{:02x}", static_cast<unsigned char>(c))
                         : std::string(1, c);
  }
  return text;
}

/** Returns the name that Escaped() writes as `text`; empty if there is none. */
std::optional<std::string> Unescaped(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      name += text[i];
      continue;
    }
    unsigned code = 0;
    const std::string_view digits = text.substr(i + 1, 2);
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, code, 16);
    if (digits.size() != 2 || error != std::errc() || stop != end) return std::nullopt;
    name += static_cast<char>(code);
    i += 2;
  }
  return name;
}

/** A word of a line. */
struct Word {
  std::string_view text;
  int column;  ///< Counted from 1.
};

std::vector<Word> WordsOf(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<Word> words;
  for (std::size_t begin = line.find_first_not_of(kBlanks);
       begin != std::string_view::npos; begin = line.find_first_not_of(kBlanks, begin)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
    begin = end;
  }
  return words;
}

/** Reads one file and collects its errors. */
class BoundsReader {
 public:
  explicit BoundsReader(const std::filesystem::path& file) : file_(file.string()) {}

  BoundsResult Read(std::string_view text) && {
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find('\n'), text.size());
      ReadLine(WordsOf(text.substr(0, end)));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (!diagnostics_.empty()) return {std::nullopt, std::move(diagnostics_)};
    return {std::move(bounds_), {}};
  }

 private:
  void Add(int column, std::string what, std::string expected) {
    diagnostics_.push_back({file_, line_, column, std::move(what), std::move(expected)});
  }

  void ReadLine(const std::vector<Word>& words) {
    if (words.empty()) return;
    if (words.size() < 3) {
      Add(words.back().column, "the line ends too soon",
          "a scenario, an oracle and bounds, e.g. excess=0.001");
      return;
    }
    const Word& scenario = words[0];
    if (!IsScenarioId(scenario.text)) {
      Add(scenario.column, fmt::format("scenario is \"{}\"", scenario.text),
          "an id of lower-case letters, digits, '_' and '/'");
    }
    const std::optional<std::string> oracle = Unescaped(words[1].text);
    if (!oracle) {
      Add(words[1].column, fmt::format("oracle is \"{}\"", words[1].text),
          "% only before two hexadecimal digits");
      return;
    }
    for (std::size_t i = 2; i < words.size(); ++i) {
      ReadBound(words[i], std::string(scenario.text), *oracle);
    }
  }

  void ReadBound(const Word& word, std::string scenario, std::string oracle) {
    const std::size_t equals = word.text.find('=');
    const std::string_view left = word.text.substr(0, equals);
    const std::size_t colon = std::min(left.find(':'), left.size());
    const std::optional<MeasureKind> measure = MeasureNamed(left.substr(0, colon));
    if (equals == std::string_view::npos || !measure) {
      Add(word.column, fmt::format("bound is \"{}\"", word.text),
          "a measure, \"=\" and a number or a verdict, e.g. excess=0.001");
      return;
    }
    const std::string_view law =
        left.substr(std::min(colon + 1, left.size()), left.size());
    const std::optional<LedgerBound> bound =
        BoundOf(word, word.text.substr(equals + 1), *measure);
    if (!bound) return;
    LedgerCell cell{std::move(scenario), std::move(oracle), *measure, std::string(law)};
    if (!bounds_.emplace(std::move(cell), *bound).second) {
      Add(word.column, fmt::format("{} is bounded twice", left), "one bound");
    }
  }

  std::optional<LedgerBound> BoundOf(const Word& word, std::string_view text,
                                     MeasureKind measure) {
    for (const auto& [verdict, name] : kWithoutValue) {
      if (text == name) return LedgerBound{verdict, 0, line_};
    }
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    // A scene that touches exactly is missed by 0 m.
    const bool too_small =
        measure == MeasureKind::kTouching ? !(value >= 0) : !(value > 0);
    const bool too_large = IsShare(measure) && value > 1;
    const bool is_broken = IsCount(measure) && value != std::floor(value);
    if (error != std::errc() || stop != end || !std::isfinite(value) || too_small ||
        too_large || is_broken) {
      Add(word.column, fmt::format("bound is \"{}\"", word.text),
          fmt::format("a {}number > 0{}, \"invalid\", \"crashed\" or \"timed_out\"",
                      IsCount(measure) ? "whole " : "",
                      IsShare(measure) ? " and at most 1" : ""));
      return std::nullopt;
    }
    return LedgerBound{Verdict::kFail, value, line_};
  }

  std::string file_;
  int line_ = 0;
  LedgerBounds bounds_;
  std::vector<Diagnostic> diagnostics_;
};

std::string TextOf(const LedgerBound& bound) {
  for (const auto& [verdict, name] : kWithoutValue) {
    if (bound.verdict == verdict) return std::string(name);
  }
  return fmt::format("{}", bound.value);
}

}  // namespace

std::filesystem::path BoundsFileOf(const std::filesystem::path& ledger) {
  return std::filesystem::path(ledger).replace_extension(".bounds");
}

BoundsResult ReadBounds(std::string_view text, const std::filesystem::path& file) {
  return BoundsReader(file).Read(text);
}

BoundsResult ReadBoundsFile(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {LedgerBounds(), {}};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    return {std::nullopt, {{file.string(), 1, 1, "cannot be read", "a file of bounds"}}};
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return ReadBounds(text.str(), file);
}

std::string WriteBounds(const LedgerBounds& bounds, std::string_view ledger) {
  std::string text = fmt::format(
      "# Bounds of {}, written by `touchstone ledger --update`.\n"
      "# Lengths are relative to the size of the scene, those of worlds are in metres.\n",
      ledger);
  const LedgerCell* last = nullptr;
  for (const auto& [cell, bound] : bounds) {
    if (last == nullptr || last->scenario != cell.scenario ||
        last->oracle != cell.oracle) {
      text += fmt::format("{}{} {}", last == nullptr ? "" : "\n", cell.scenario,
                          Escaped(cell.oracle));
    }
    text += fmt::format(" {}{}{}={}", NameOf(cell.measure), cell.law.empty() ? "" : ":",
                        cell.law, TextOf(bound));
    last = &cell;
  }
  return text + (bounds.empty() ? "" : "\n");
}

bool HasValue(Verdict verdict) {
  return verdict == Verdict::kFail || verdict == Verdict::kDisagree;
}

bool IsShare(MeasureKind measure) {
  return measure == MeasureKind::kPatchCoverage || measure == MeasureKind::kAnswering ||
         measure == MeasureKind::kDeterminism;
}

bool IsCount(MeasureKind measure) {
  return measure == MeasureKind::kContactCount;
}

}  // namespace touchstone
