#include "reports/finding/ending.h"

#include <regex>

namespace touchstone {

std::string KindOfProof(const std::string& proof) {
  // Also hexadecimal numbers, and exponents with a sign.
  static const std::regex number("(^|[^:0-9])-?[0-9][0-9A-Za-z.]*([-+][0-9]+)?");
  return std::regex_replace(proof, number, "$1#");
}

std::string EndingOf(const Finding& finding) {
  switch (finding.verdict) {
    case Verdict::kCrashed:
    case Verdict::kTimedOut:
    case Verdict::kInvalid:
      return KindOfProof(finding.proof.starts_with(finding.oracle + ": ")
                             ? finding.proof.substr(finding.oracle.size() + 2)
                             : finding.proof);
    default:
      return "";
  }
}

}  // namespace touchstone
