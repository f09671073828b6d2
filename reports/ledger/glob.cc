#include "reports/ledger/glob.h"

namespace touchstone {

bool MatchesGlob(std::string_view pattern, std::string_view path) {
  // The recursion depth is the number of stars in the pattern.
  while (!pattern.empty() && pattern.front() != '*') {
    if (path.empty() || path.front() != pattern.front()) return false;
    pattern.remove_prefix(1);
    path.remove_prefix(1);
  }
  if (pattern.empty()) return path.empty();
  const bool across = pattern.starts_with("**");
  pattern.remove_prefix(across ? 2 : 1);
  while (true) {
    if (MatchesGlob(pattern, path)) return true;
    if (path.empty() || (path.front() == '/' && !across)) return false;
    path.remove_prefix(1);
  }
}

}  // namespace touchstone
