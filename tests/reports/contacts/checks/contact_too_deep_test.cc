#include "reports/contacts/checks/contact_too_deep.h"

#include <gtest/gtest.h>

#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

constexpr double kDepth = 2e-3;        // [m]
constexpr double kRounding = 0x1p-46;  // [m], 64 roundings of a scene below 2 m

TEST(ContactTooDeep, CountsDeeperContactsOnly) {
  const Specimen s = SphereInBoxFace(kDepth);
  EXPECT_EQ(ContactTooDeep(s.truth, {s.right.points[0].p_WC, -kDepth, {}}), 0);
  EXPECT_EQ(ContactTooDeep(s.truth, {s.right.points[0].p_WC, -kDepth / 2, {}}), 0);
  EXPECT_NEAR(ContactTooDeep(s.truth, {s.right.points[0].p_WC, -2 * kDepth, {}}), kDepth,
              kRounding);
}

}  // namespace
}  // namespace touchstone
