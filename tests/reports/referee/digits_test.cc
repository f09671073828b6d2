// Tests of when a proof in double-double is left as it is.

#include "reports/referee/digits.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "reports/referee/core_truth.h"
#include "reports/referee/half_space.h"
#include "reports/referee/proved.h"
#include "reports/referee/unit_scale.h"
#include "tests/reports/referee/hard_question.h"

namespace touchstone::referee {
namespace {

double Width(const Enclosure& e) {
  return e.hi - e.lo;
}

bool HasSign(const Enclosure& e) {
  return e.lo > 0 || e.hi < 0;
}

TEST(Digits, AreLeftOnlyWhereMoreWouldProveNoOtherSignAndHardlyANarrowerTruth) {
  int left = 0;
  int repeated = 0;
  for (std::uint64_t i = 0; i < 3024; ++i) {
    const ContactQuery query = HardQuestionAt(1, i).query;
    if (HasHalfSpace(query)) continue;
    const auto [scaled, unit] = InOwnUnit(query);
    const MinkowskiDifference M(scaled.A, scaled.B);
    const CoreTruth<DoubleDouble> core = JudgeCores<DoubleDouble>(M);
    const Enclosure quick = Proved(scaled, core);
    if (!IsFinal(core.separation, quick, M)) {
      ++repeated;
      continue;
    }
    ++left;
    SCOPED_TRACE(testing::Message() << "question " << i);
    const Enclosure sharp = Proved(scaled, JudgeCores<Precise>(M));
    EXPECT_LE(std::max(quick.lo, sharp.lo), std::min(quick.hi, sharp.hi));
    EXPECT_TRUE(HasSign(quick) || IsTight(quick) || !HasSign(sharp));
    const double separation = std::abs(quick.lo + quick.hi) / 2;
    const double rounding = 0x1p-52 * M.Size();
    EXPECT_LE(Width(quick) - Width(sharp), std::max(0x1p-40 * separation, rounding));
  }
  EXPECT_GT(left, 1500);
  EXPECT_GT(repeated, 20);
}

}  // namespace
}  // namespace touchstone::referee
