#include <cmath>
#include <cstddef>

#include "reports/shrink/reductions.h"
#include "reports/shrink/round_to_digits.h"

namespace touchstone {

void ShortNumbers(const Question& question, const Candidates& take) {
  Question copy = question;
  const std::vector<double*> numbers = NumbersOf(copy);
  for (int digits = 1; digits <= kSurelyKeptDigits; ++digits) {
    Question rounded = question;
    for (double* const number : NumbersOf(rounded))
      *number = RoundToDigits(*number, digits);
    take(std::move(rounded));
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double exact = *numbers[i];
    const auto add = [&](double shorter) {
      if (shorter == exact) return;
      Question candidate = question;
      *NumbersOf(candidate)[i] = shorter;
      take(std::move(candidate));
    };
    add(0);
    add(1);
    add(std::abs(exact));
    for (int digits = 1; digits <= kSurelyKeptDigits; ++digits)
      add(RoundToDigits(exact, digits));
  }
}

}  // namespace touchstone
