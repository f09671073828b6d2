#include "reports/contacts/causes/margin.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace touchstone {
namespace {

/** Returns the end of the run of equal errors that starts at `begin`; `errors` is sorted.
 */
std::size_t EndOfRun(std::span<const SignedError> errors, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < errors.size() &&
         errors[end].error - errors[begin].error <=
             errors[begin].finding->tolerance + errors[end].finding->tolerance) {
    ++end;
  }
  return end;
}

int DifferentTruths(std::span<const SignedError> run) {
  std::vector<double> truths;
  double widest = 0;
  for (const SignedError& e : run) {
    truths.push_back(e.truth);
    widest = std::max(widest, 2 * e.finding->tolerance);
  }
  std::sort(truths.begin(), truths.end());
  int different = 1;
  double last = truths.front();
  for (const double truth : truths) {
    if (truth - last <= widest) continue;
    ++different;
    last = truth;
  }
  return different;
}

bool HasSeveralSizes(std::span<const SignedError> run) {
  return std::any_of(run.begin(), run.end(),
                     [&](const SignedError& e) { return e.sizes != run.front().sizes; });
}

/** Returns whether an answer is too exact to have a margin of `margin`. [m] */
bool Contradicts(const SignedError& pass, double margin, double tolerance) {
  return std::abs(pass.error - margin) > pass.finding->tolerance + tolerance;
}

constexpr std::string_view kMargin = ": a margin";

}  // namespace

bool IsMargin(const Finding& finding) {
  return finding.cause == Cause::kConvention && finding.cause_because.ends_with(kMargin);
}

void ExplainByMargin(std::span<SignedError> errors, std::span<const SignedError> passes) {
  std::sort(errors.begin(), errors.end(),
            [](const SignedError& a, const SignedError& b) { return a.error < b.error; });
  for (std::size_t begin = 0; begin < errors.size();) {
    const std::size_t end = EndOfRun(errors, begin);
    const std::span<SignedError> run = errors.subspan(begin, end - begin);
    const auto contradicts = [&](const SignedError& pass) {
      return Contradicts(pass, run.front().error, run.front().finding->tolerance);
    };
    if (DifferentTruths(run) >= kMarginWitnesses && HasSeveralSizes(run) &&
        std::none_of(passes.begin(), passes.end(), contradicts)) {
      for (SignedError& e : run) {
        e.finding->cause = Cause::kConvention;
        e.finding->cause_because =
            fmt::format("its separation is off by the same {:.6g} m in {} questions{}",
                        e.error, run.size(), kMargin);
      }
    }
    begin = end;
  }
}

}  // namespace touchstone
