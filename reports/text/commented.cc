#include "reports/text/commented.h"

#include <algorithm>

#include "reports/text/wrapped.h"

namespace touchstone {

std::string Commented(std::string_view text, std::string_view mark) {
  constexpr std::size_t kWidth = 90;
  std::string comment;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string lines =
        Wrapped(text.substr(begin, end - begin), kWidth - mark.size(), 0);
    comment += mark;
    for (const char c : lines) {
      comment += c;
      if (c == '\n') comment += mark;
    }
    comment += '\n';
    begin = end + 1;
  }
  return comment;
}

}  // namespace touchstone
