#include "reports/finding/ending.h"

#include <regex>

namespace touchstone {

std::string KindOfProof(const std::string& proof) {
  // The line of a file; or a number, also hexadecimal, or with a signed exponent.
  static const std::regex number("(:[0-9]+:)|-?[0-9][0-9A-Za-z.]*([-+][0-9]+)?");
  std::string kind;
  std::sregex_iterator match(proof.begin(), proof.end(), number);
  auto rest = proof.begin();
  for (; match != std::sregex_iterator(); ++match) {
    kind.append(rest, (*match)[0].first);
    kind += (*match)[1].matched ? match->str() : "#";
    rest = (*match)[0].second;
  }
  return kind.append(rest, proof.end());
}

std::string EndingInWords(const Finding& finding) {
  if (!IsUnusable(finding.verdict)) return "";
  return finding.proof.starts_with(finding.oracle + ": ")
             ? finding.proof.substr(finding.oracle.size() + 2)
             : finding.proof;
}

std::string EndingOf(const Finding& finding) {
  return KindOfProof(EndingInWords(finding));
}

}  // namespace touchstone
