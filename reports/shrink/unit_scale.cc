#include <algorithm>
#include <cmath>

#include "reports/shrink/reductions.h"
#include "reports/shrink/round_to_digits.h"

namespace touchstone {

void UnitScale(const Question& question, const Candidates& take) {
  if (!std::holds_alternative<Scenario>(question)) return;
  std::vector<double> sizes;
  for (const Body* const body : BodiesOf(question)) {
    const double size = BoundingRadius(body->shape);
    if (size > 0) sizes.push_back(size);
  }
  std::sort(sizes.begin(), sizes.end());
  for (const double size : sizes) {
    const double exponent = std::floor(std::log10(size));
    for (const double lower : {exponent, exponent + 1}) {
      if (lower == 0) continue;
      Question scaled = question;
      for (double* const number : NumbersOf(scaled)) {
        const double exact = *number * std::pow(10.0, -lower);
        *number = RoundToDigits(exact, kSurelyKeptDigits);
      }
      take(std::move(scaled));
    }
  }
}

}  // namespace touchstone
