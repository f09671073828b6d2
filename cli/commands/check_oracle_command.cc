#include "cli/commands/check_oracle_command.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/input_error.h"
#include "oracles/protocol/external_oracle.h"
#include "reports/adapter_check/check_contacts.h"
#include "reports/adapter_check/check_worlds.h"
#include "reports/text/counted.h"
#include "reports/text/wrapped.h"

namespace touchstone {
namespace {

const std::string kUnexplained =
    "no mistake of adapters that we know explains this, so that it may be the engine";

// One word of a command, so that the shell does not take it apart.
std::string Quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted;
  for (const char c : word) {
    if (c == '\'')
      quoted += "'\\''";
    else
      quoted.push_back(c);
  }
  return fmt::format("'{}'", quoted);
}

// The command of `words`: a single one is a line for the shell already.
std::string LineOf(const std::vector<std::string>& words) {
  if (words.size() == 1) return words.front();
  std::vector<std::string> quoted;
  quoted.reserve(words.size());
  for (const std::string& word : words) quoted.push_back(Quoted(word));
  return fmt::format("{}", fmt::join(quoted, " "));
}

std::unique_ptr<Oracle> Started(const std::string& line) {
  try {
    return MakeExternalOracle("", {line});
  } catch (const std::runtime_error& error) {
    throw InputError(
        fmt::format("`{}` is no oracle: {}; expected a program that answers the oracle "
                    "protocol (docs/oracle_protocol.md)",
                    line, error.what()));
  }
}

// Prints a paragraph after a sign, in lines that fit a terminal.
void PrintParagraph(std::string_view sign, const std::string& text) {
  constexpr std::size_t kColumns = 96;
  constexpr std::size_t kIndent = 4;
  std::cout << fmt::format("  {} {}\n", sign, Wrapped(text, kColumns - kIndent, kIndent));
}

std::string NameOf(const PairCheck& pair) {
  return fmt::format("{} {}", NameOf(pair.A), NameOf(pair.B));
}

// Counts the answers that are neither right nor wrong: " (3 inexact, 1 undecidable)".
std::string RestOf(const PairCheck& pair) {
  const std::size_t undecidable =
      pair.asked - pair.right - pair.wrong - pair.inexact - pair.unsupported;
  std::vector<std::string> parts;
  for (const auto& [count, what] :
       {std::pair(pair.inexact, "inexact"), std::pair(pair.unsupported, "unsupported"),
        std::pair(undecidable, "undecidable")}) {
    if (count > 0) parts.push_back(fmt::format("{} {}", count, what));
  }
  return parts.empty() ? "" : fmt::format(" ({})", fmt::join(parts, ", "));
}

bool IsChecked(const PairCheck& pair) {
  return pair.right + pair.inexact + pair.wrong > 0;
}

std::string AnyOf(const std::vector<std::string>& mistakes) {
  return fmt::format("{}", fmt::join(mistakes, "; or "));
}

// Prints the pairs whose answers are right, then the others by what explains them.
// Returns whether an answer was wrong.
bool PrintPairs(const std::vector<PairCheck>& pairs) {
  if (pairs.empty()) return false;
  std::cout << fmt::format(
      "Contact questions: {} random ones of each pair of shapes, judged against the "
      "certified truth\n",
      pairs.front().asked);
  std::vector<std::string> right;
  std::vector<std::string> undecided;
  std::map<std::string, std::vector<std::string>> wrong;  // By what explains them.
  const PairCheck* unexplained = nullptr;
  for (const PairCheck& pair : pairs) {
    if (pair.wrong == 0) {
      (IsChecked(pair) ? right : undecided).push_back(NameOf(pair) + RestOf(pair));
      continue;
    }
    if (pair.mistakes.empty() && unexplained == nullptr) unexplained = &pair;
    wrong[AnyOf(pair.mistakes)].push_back(
        fmt::format("{} ({} of {} wrong)", NameOf(pair), pair.wrong, pair.asked));
  }
  if (!right.empty())
    PrintParagraph("✓", fmt::format("right: {}", fmt::join(right, ", ")));
  if (!undecided.empty())
    PrintParagraph("–", fmt::format("nothing decided: {}", fmt::join(undecided, ", ")));
  for (const auto& [mistake, names] : wrong) {
    PrintParagraph("✗", fmt::format("{}: {}", mistake.empty() ? kUnexplained : mistake,
                                    fmt::join(names, ", ")));
  }
  if (unexplained != nullptr) {
    PrintParagraph(
        " ", fmt::format("e.g. {}: {}", NameOf(*unexplained), unexplained->example));
  }
  return !wrong.empty();
}

// Returns whether a motion was wrong.
bool PrintWorlds(const std::vector<WorldCheck>& worlds) {
  if (worlds.empty()) return false;
  std::cout
      << "Worlds: half a second of free motion, compared with the cookbook engine\n";
  bool is_wrong = false;
  for (const WorldCheck& world : worlds) {
    if (!world.reason.empty()) {
      PrintParagraph("–", fmt::format("{}: unsupported, {}", world.world, world.reason));
    } else if (world.wrong.empty()) {
      PrintParagraph("✓", world.world);
    } else {
      is_wrong = true;
      PrintParagraph("✗", fmt::format("{}: {}; {}", world.world, world.wrong,
                                      world.mistakes.empty() ? kUnexplained
                                                             : AnyOf(world.mistakes)));
    }
  }
  return is_wrong;
}

}  // namespace

int CheckOracleCommand(const Session& session, const std::vector<std::string>& words) {
  const Oracle* named =
      words.size() == 1 ? session.registry.Find(words.front()) : nullptr;
  std::unique_ptr<Oracle> started;
  if (named == nullptr) started = Started(LineOf(words));
  const Oracle& oracle = named != nullptr ? *named : *started;
  const OracleInfo& info = oracle.info();
  std::cout << fmt::format("{}: {} {}, {}\n", info.name, info.library, info.version,
                           info.unit_roundoff < 1e-10 ? "double" : "float");

  const std::vector<PairCheck> pairs = CheckContacts(oracle);
  bool is_wrong = PrintPairs(pairs);
  if (!pairs.empty()) {
    const std::string difference = CheckRepeatability(oracle);
    is_wrong = is_wrong || !difference.empty();
    PrintParagraph(difference.empty() ? "✓" : "✗",
                   difference.empty()
                       ? "the same bits when asked again, alone and in another order"
                       : difference);
  }
  const std::vector<WorldCheck> worlds =
      CheckWorlds(oracle, *session.registry.Find("cookbook"));
  is_wrong = PrintWorlds(worlds) || is_wrong;

  const auto simulated = std::ranges::count_if(
      worlds, [](const WorldCheck& world) { return world.reason.empty(); });
  const auto checked = std::ranges::count_if(pairs, IsChecked);
  if (checked == 0 && simulated == 0) {
    throw InputError(fmt::format(
        "nothing of {} was checked; expected an oracle that answers a pair of shapes, or "
        "simulates a moving sphere or box",
        info.name));
  }
  std::cout << fmt::format("{}: {} and {} checked\n",
                           is_wrong ? "Something is wrong" : "Nothing is wrong",
                           Counted(static_cast<std::size_t>(checked), "pair"),
                           Counted(static_cast<std::size_t>(simulated), "world"));
  return is_wrong ? 1 : 0;
}

}  // namespace touchstone
