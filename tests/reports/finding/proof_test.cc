#include "reports/finding/proof.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

// Exactly touching: the depth to compare with is 0, and no sign tells it from a gap.
TEST(InWords, ComparesADepthWithTheDepthOfBodiesThatJustTouch) {
  const Proof proof{.kind = ProofKind::kTranslation,
                    .claim = ProofClaim::kSeparation,
                    .said = -0.5,
                    .bound = 0,
                    .n_W = {0, 0, 1}};
  EXPECT_EQ(InWords(proof, "mine"),
            "mine says 0.5 m deep; moving B by 0 m along (0, 0, 1) separates them, 0.5 m "
            "less.");
}

}  // namespace
}  // namespace touchstone
