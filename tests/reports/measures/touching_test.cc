#include "reports/measures/touching.h"

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

TEST(TouchingError, IsOneForAMissedContact) {
  Specimen specimen = SphereInBoxFace(2e-3);
  EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 0);
  specimen.right.touching = false;
  EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 1);
}

TEST(TouchingError, IsOneForAPhantomContact) {
  Specimen specimen = SphereInBoxFace(-2e-3);
  EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 0);
  specimen.right.touching = true;
  EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 1);
}

TEST(TouchingError, IsZeroForAnUndecidedTruth) {
  Specimen specimen = SphereInBoxFace(0);
  specimen.truth.touching = Touching::kUndecided;
  for (const bool touching : {false, true}) {
    specimen.right.touching = touching;
    EXPECT_EQ(TouchingError(specimen.truth, specimen.right), 0);
  }
}

}  // namespace
}  // namespace touchstone
