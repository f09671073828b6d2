#include "scenarios/toml/check_nesting.h"

#include <cstddef>

#include <fmt/format.h>

#include "scenarios/limits.h"

namespace touchstone {
namespace {

/** Walks a TOML text from token to token and counts the dots of each key. A number has at
 most one dot, so values need no treatment of their own. */
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  /** Returns whether no key is too deep; otherwise the walk stands after its last dot. */
  bool IsShallow() {
    int levels = 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        Skip(text_.find('\n', at_));
      } else if (c == '"' || c == '\'') {
        SkipString(c);
      } else {
        Step();
        if (c == '.') {
          if (++levels > kMostKeyLevels) return false;
        } else if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' ||
                   c == '{' || c == '}') {
          levels = 1;
        }
      }
    }
    return true;
  }

  toml::source_position Place() const {
    return {static_cast<toml::source_index>(line_),
            static_cast<toml::source_index>(column_)};
  }

 private:
  void Step() {
    // A byte that continues a code point has no column of its own.
    const auto byte = static_cast<unsigned char>(text_[at_++]);
    if (byte == '\n') {
      ++line_;
      column_ = 1;
    } else if ((byte & 0xC0U) != 0x80U) {
      ++column_;
    }
  }

  void Skip(std::size_t to) {
    if (to == std::string_view::npos) to = text_.size();
    while (at_ < to) Step();
  }

  /** Skips a string that starts here with `quote`: of one line, or of several after three
   quotes. A string of one line ends at the end of the line too, closed or not. */
  void SkipString(char quote) {
    const std::string_view rest = text_.substr(at_);
    const bool several = rest.size() > 2 && rest[1] == quote && rest[2] == quote;
    Skip(at_ + (several ? 3 : 1));
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\\' && quote == '"') {
        Skip(at_ + 2 < text_.size() ? at_ + 2 : text_.size());
      } else if (!several && c == '\n') {
        return;
      } else if (c == quote &&
                 (!several || text_.substr(at_, 3) == std::string_view(rest.data(), 3))) {
        Skip(at_ + (several ? 3 : 1));
        return;
      } else {
        Step();
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
};

}  // namespace

bool CheckNesting(std::string_view text, FileLog& log) {
  Walk walk(text);
  if (walk.IsShallow()) return true;
  log.Add(toml::source_region{walk.Place(), walk.Place(), nullptr},
          fmt::format("the key has more than {} levels", kMostKeyLevels),
          fmt::format("at most {} names with dots between them", kMostKeyLevels));
  return false;
}

}  // namespace touchstone
