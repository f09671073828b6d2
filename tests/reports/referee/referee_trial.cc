// Puts hard questions to the referee and to a second one that shares nothing with it.
//
//     referee_trial [COUNT [SEED]]
//
// Prints a table of contradictions and of widths, and returns 1 if an enclosure of the
// referee misses the truth, if a certificate does not prove its bound, or if the widths
// are not those that are expected: wider ones prove less, and narrower ones too much.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/referee/referee.h"
#include "reports/threads/parallel_for.h"
#include "scenarios/validate.h"
#include "tests/reports/referee/hard_question.h"
#include "tests/reports/referee/second_referee.h"

namespace touchstone {
namespace {

/** The comparison of both referees on one question. */
struct Comparison {
  bool valid = true;  ///< Whether the question is valid at all.
  std::string complaint;
  std::string_view hardening;
  bool half_space = false;
  double width = 0;   ///< Of the referee's enclosure, relative to the scene. [-]
  double second = 0;  ///< Of the second's, likewise. [-]
};

bool HasHalfSpace(const ContactQuery& query) {
  return KindOf(query.A.shape) == ShapeKind::kHalfSpace ||
         KindOf(query.B.shape) == ShapeKind::kHalfSpace;
}

/** Returns the size of which both compute: the distance of the bodies and their radii.
 [m] */
double SizeOf(const ContactQuery& query) {
  return (query.A.X_WB.p_WB - query.B.X_WB.p_WB).norm() + BoundingRadius(query.A.shape) +
         BoundingRadius(query.B.shape);
}

Comparison Compare(std::uint64_t seed, std::uint64_t index) {
  const HardQuestion question = HardQuestionAt(seed, index);
  const ContactQuery& query = question.query;
  Comparison result;
  result.hardening = question.hardening;
  result.valid = FaultsOf(query).empty();
  if (!result.valid) return result;
  result.half_space = HasHalfSpace(query);
  const ContactTruth truth = ComputeContactTruth(query);
  const Enclosure& e = truth.separation;
  const WideEnclosure second = SeparationBySearch(query);
  const double size = SizeOf(query);
  result.width = (e.hi - e.lo) / size;
  result.second = static_cast<double>(Wide(second.hi - second.lo) / size);
  if (second.lo > second.hi) {
    result.complaint = "the second referee contradicts itself";
  } else if (e.hi < second.lo || e.lo > second.hi) {
    result.complaint = fmt::format(
        "[{:.17g}, {:.17g}] m, but a second referee says [{:.17g}, {:.17g}]", e.lo, e.hi,
        static_cast<double>(second.lo), static_cast<double>(second.hi));
  } else if (!result.half_space && GapAlong(query, truth.certificate.n_AB_W) < e.lo) {
    result.complaint =
        fmt::format("the certificate proves {:.17g} m, not {:.17g}",
                    static_cast<double>(GapAlong(query, truth.certificate.n_AB_W)), e.lo);
  }
  return result;
}

/** @pre `sorted` is not empty. */
double Quantile(const std::vector<double>& sorted, double share) {
  const double last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(share * last)];
}

/** Prints a row of the table. @pre `of` is not empty. */
void PrintRow(std::string_view name, const std::vector<const Comparison*>& of) {
  std::vector<double> width;
  std::vector<double> second;
  std::size_t wrong = 0;
  for (const Comparison* c : of) {
    width.push_back(c->width);
    second.push_back(c->second);
    wrong += c->complaint.empty() ? 0 : 1;
  }
  std::sort(width.begin(), width.end());
  std::sort(second.begin(), second.end());
  fmt::print("{:16} {:9} {:6}  {:8.1e} {:8.1e} {:8.1e} {:8.1e}  {:8.1e} {:8.1e}\n", name,
             of.size(), wrong, Quantile(width, 0.5), Quantile(width, 0.9),
             Quantile(width, 0.99), width.back(), Quantile(second, 0.9), second.back());
}

/** Prints how many widths lie in each decade. */
void PrintHistogram(const std::vector<const Comparison*>& of) {
  constexpr int kLeast = -21;
  std::array<std::size_t, 23> decades{};
  std::size_t none = 0;
  for (const Comparison* c : of) {
    if (c->width == 0) {
      ++none;
      continue;
    }
    const int decade = static_cast<int>(std::floor(std::log10(c->width)));
    ++decades[static_cast<std::size_t>(std::clamp(decade, kLeast, 1) - kLeast)];
  }
  fmt::print("\nwidth / size      questions\n{:16} {:10}\n", "0 (exact)", none);
  for (std::size_t i = 0; i < decades.size(); ++i) {
    if (decades[i] == 0) continue;
    const int decade = kLeast + static_cast<int>(i);
    fmt::print("{:16} {:10}\n",
               fmt::format("{}1e{} to 1e{}", i == 0 ? "under " : "", decade, decade + 1),
               decades[i]);
  }
}

/** Prints which questions have the widest enclosures. */
void PrintWidest(const std::vector<Comparison>& all) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::size_t most = std::min<std::size_t>(all.size(), 12);
  std::partial_sort(
      order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end(),
      [&](std::size_t i, std::size_t j) { return all[i].width > all[j].width; });
  fmt::print("\nwidest:");
  for (std::size_t i = 0; i < most; ++i)
    fmt::print(" {} ({:.1e})", order[i], all[order[i]].width);
  fmt::print("\n");
}

/** A share of the questions and the limits of their greatest width. */
struct Expected {
  double share;
  double least;  ///< [-]
  double most;   ///< [-]
};

/** Expected widths relative to the scene, four times as narrow and as wide as measured
 with 10^5 questions. An enclosure of doubles is no narrower than their spacing: about
 half of the questions have flat faces and a separation of a tenth of the scene, whose
 spacing is 2^-56 of the scene. Round faces add the rounding of a point in double, some
 2^-52. If the least overlap is reached along a curve of directions, a thousand facets
 leave up to their squared spacing. */
constexpr std::array kExpected = {
    Expected{0.5, 0x1p-58, 0x1p-54}, Expected{0.9, 0x1p-54, 0x1p-49},
    Expected{0.99, 0x1p-52, 0x1p-47}, Expected{0.998, 0x1p-52, 1e-12},
    Expected{1, 0x1p-52, 1e-4}};

/** Prints the widths that are not as expected, and returns how many. */
int CountUnexpected(const std::vector<Comparison>& all) {
  std::vector<double> width;
  for (const Comparison& c : all) {
    if (c.valid) width.push_back(c.width);
  }
  std::sort(width.begin(), width.end());
  int unexpected = 0;
  for (const Expected& e : kExpected) {
    const double w = Quantile(width, e.share);
    if (w >= e.least && w <= e.most) continue;
    ++unexpected;
    fmt::print("{} % of the widths are up to {:.1e}, expected {:.1e} to {:.1e}\n",
               100 * e.share, w, e.least, e.most);
  }
  return unexpected;
}

int Main(std::uint64_t count, std::uint64_t seed) {
  std::vector<Comparison> all(count);
  ParallelFor(count, 0, [&](std::size_t i) { all[i] = Compare(seed, i); });
  std::vector<const Comparison*> valid;
  int failures = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].valid) continue;
    valid.push_back(&all[i]);
    if (all[i].complaint.empty()) continue;
    ++failures;
    if (failures <= 20)
      fmt::print("question {} of seed {}: {}\n", i, seed, all[i].complaint);
  }
  fmt::print("{} questions of seed {}, of which {} are valid\n\n", count, seed,
             valid.size());
  fmt::print("{:16} {:>9} {:>6}  {:^35}  {:^17}\n", "", "", "", "width / size",
             "of the second");
  fmt::print("{:16} {:>9} {:>6}  {:>8} {:>8} {:>8} {:>8}  {:>8} {:>8}\n", "", "questions",
             "wrong", "50 %", "90 %", "99 %", "most", "90 %", "most");
  for (const std::string_view hardening : kHardenings) {
    std::vector<const Comparison*> of;
    std::copy_if(valid.begin(), valid.end(), std::back_inserter(of),
                 [&](const Comparison* c) { return c->hardening == hardening; });
    if (!of.empty()) PrintRow(hardening, of);
  }
  PrintRow("all", valid);
  PrintWidest(all);
  PrintHistogram(valid);
  return failures + CountUnexpected(all) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace touchstone

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 3024;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  if (count == 0) {
    fmt::print(stderr, "referee_trial: COUNT is {}; expected a number > 0\n", argv[1]);
    return 2;
  }
  return touchstone::Main(count, seed);
}
