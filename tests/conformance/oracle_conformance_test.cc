// The contract of an oracle, stated once and kept by every oracle there is. An adapter is
// done when it is listed here and green.

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"
#include "tests/conformance/contract.h"
#include "tests/oracles/constructed_contact.h"

namespace touchstone {
namespace {

using Cell = std::array<ShapeKind, 2>;

const OracleRegistry& Registry() {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry;
}

/** What an oracle cannot do, in full: every pair with one of `shapes`, and each of
 `pairs`. */
struct Unsupported {
  std::string_view oracle;
  std::vector<ShapeKind> shapes;
  std::vector<Cell> pairs;
};

constexpr Cell kTwoHalfSpaces = {ShapeKind::kHalfSpace, ShapeKind::kHalfSpace};

const std::vector<Unsupported> kUnsupported = {
    {"cookbook",
     {ShapeKind::kCapsule, ShapeKind::kCylinder, ShapeKind::kCone, ShapeKind::kConvexHull,
      ShapeKind::kHalfSpace},
     {}},
    {"bullet", {}, {kTwoHalfSpaces}},
    {"bullet/gjk", {ShapeKind::kHalfSpace}, {}},
    {"bullet_float", {}, {kTwoHalfSpaces}},
    {"bullet_float/gjk", {ShapeKind::kHalfSpace}, {}},
    {"ode", {ShapeKind::kCone}, {kTwoHalfSpaces}},
};

/** A fault of an engine that shows even here. Asserted: once it is gone, its row must go.
 */
struct EngineFault {
  std::string_view oracle;
  Cell pair;                              ///< In the order of ShapeKind.
  std::vector<std::string_view> clauses;  ///< Those that it breaks.
  std::string_view why;
};

const std::vector<EngineFault> kEngineFaults = {
    {"ode",
     {ShapeKind::kBox, ShapeKind::kCylinder},
     {"KnownAnswer", "PushApart", "RigidMotion"},
     "ODE takes the sine of the angle between cylinder and box axes as sqrt(1 - cos^2), "
     "which "
     "near 0 has half the digits, and multiplies it by the radius "
     "(collision_cylinder_box.cpp)"},
    {"ode",
     {ShapeKind::kCylinder, ShapeKind::kConvexHull},
     {"KnownAnswer", "PushApart", "RigidMotion"},
     "along the cylinder's axis, ODE's support point normalises what rounding leaves of "
     "the "
     "direction across it, which may point along the axis: up to a radius beyond the end "
     "(ccdSupportCyl in collision_libccd.cpp)"},
};

/** Names of tests hold letters, digits and underscores only. */
std::string TestName(std::string_view name) {
  std::string test_name(name);
  std::replace_if(
      test_name.begin(), test_name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return test_name;
}

std::vector<std::string> OracleNames() {
  std::vector<std::string> names;
  for (const Oracle* oracle : Registry().All()) names.push_back(oracle->info().name);
  return names;
}

class OracleConformance : public testing::TestWithParam<std::string> {
 protected:
  const Oracle& oracle() const { return *Registry().Find(GetParam()); }
};

TEST_P(OracleConformance, SaysExactlyWhatItCannotDoAndWhy) {
  std::set<Cell> expected;
  bool listed = false;
  for (const Unsupported& row : kUnsupported) {
    if (row.oracle != GetParam()) continue;
    listed = true;
    for (const Cell& pair : row.pairs) {
      expected.insert(pair);
      expected.insert({pair[1], pair[0]});
    }
    for (const ShapeKind shape : row.shapes) {
      for (int i = 0; i < kShapeKinds; ++i) {
        expected.insert({shape, static_cast<ShapeKind>(i)});
        expected.insert({static_cast<ShapeKind>(i), shape});
      }
    }
  }
  ASSERT_TRUE(listed) << "add a row to kUnsupported, empty if it can do everything";

  for (int i = 0; i < kShapeKinds; ++i) {
    for (int j = 0; j < kShapeKinds; ++j) {
      const Cell cell = {static_cast<ShapeKind>(i), static_cast<ShapeKind>(j)};
      SCOPED_TRACE(std::string(NameOf(cell[0])) + " - " + std::string(NameOf(cell[1])));
      const Capability& capability = oracle().info().For(cell[0], cell[1]);
      EXPECT_NE(capability.supported, expected.contains(cell));
      EXPECT_NE(capability.supported, capability.family.empty());
      EXPECT_EQ(capability.supported, capability.reason.empty());
      if (!capability.supported && cell != kTwoHalfSpaces) {
        const ContactAnswer answer =
            oracle().Answer(PutTogether(cell[0], cell[1], -2e-3).query);
        EXPECT_EQ(answer.status, AnswerStatus::kUnsupported);
        EXPECT_EQ(answer.reason, capability.reason);
      }
    }
  }
}

TEST_P(OracleConformance, IsAPureFunction) {
  EXPECT_EQ(Pure(oracle()), Breaches());
}

INSTANTIATE_TEST_SUITE_P(, OracleConformance, testing::ValuesIn(OracleNames()),
                         [](const auto& instance) { return TestName(instance.param); });

/** One oracle and two kinds of shape that it supports. */
struct PairCase {
  std::string oracle;
  ShapeKind a;
  ShapeKind b;
};

void PrintTo(const PairCase& c, std::ostream* out) {
  *out << c.oracle << ": " << NameOf(c.a) << " - " << NameOf(c.b);
}

std::vector<PairCase> SupportedPairs() {
  std::vector<PairCase> cases;
  for (const Oracle* oracle : Registry().All()) {
    for (int i = 0; i < kShapeKinds; ++i) {
      for (int j = i; j < kShapeKinds; ++j) {
        const auto a = static_cast<ShapeKind>(i);
        const auto b = static_cast<ShapeKind>(j);
        if (oracle->info().For(a, b).supported) {
          cases.push_back({oracle->info().name, a, b});
        }
      }
    }
  }
  return cases;
}

class PairConformance : public testing::TestWithParam<PairCase> {
 protected:
  /* Expects `clause` to be kept, or where the table says otherwise, broken. */
  void Check(std::string_view name,
             Breaches (*clause)(const Oracle&, ShapeKind, ShapeKind)) {
    const PairCase& c = GetParam();
    const Breaches breaches = clause(*Registry().Find(c.oracle), c.a, c.b);
    for (const EngineFault& fault : kEngineFaults) {
      if (fault.oracle == c.oracle && fault.pair == Cell{c.a, c.b} &&
          std::find(fault.clauses.begin(), fault.clauses.end(), name) !=
              fault.clauses.end()) {
        EXPECT_FALSE(breaches.empty())
            << "improved: remove the row of kEngineFaults that says: " << fault.why;
        return;
      }
    }
    EXPECT_EQ(breaches, Breaches());
  }
};

TEST_P(PairConformance, KnownAnswer) {
  Check("KnownAnswer", KnownAnswer);
}

TEST_P(PairConformance, SwappingBodiesOnlyNegatesTheNormal) {
  Check("Swap", Swap);
}

TEST_P(PairConformance, PushedApartByTheirSeparationTheyNoLongerTouch) {
  Check("PushApart", PushApart);
}

TEST_P(PairConformance, RigidMotionOnlyTurnsTheNormal) {
  Check("RigidMotion", RigidMotion);
}

INSTANTIATE_TEST_SUITE_P(, PairConformance, testing::ValuesIn(SupportedPairs()),
                         [](const auto& instance) {
                           return TestName(instance.param.oracle) + "__" +
                                  std::string(NameOf(instance.param.a)) + "__" +
                                  std::string(NameOf(instance.param.b));
                         });

TEST(ConformanceTables, NameOnlyOraclesThatExistOrAreMissing) {
  const auto is_known = [](std::string_view name) {
    if (Registry().Find(name) != nullptr) return true;
    const auto& missing = Registry().missing();
    return std::any_of(missing.begin(), missing.end(), [&](const MissingOracle& m) {
      return name == m.name || name.starts_with(m.name + "/");
    });
  };
  for (const Unsupported& row : kUnsupported)
    EXPECT_TRUE(is_known(row.oracle)) << row.oracle;
  for (const EngineFault& row : kEngineFaults) {
    EXPECT_TRUE(is_known(row.oracle)) << row.oracle;
    EXPECT_FALSE(row.why.empty()) << row.oracle;
  }
}

}  // namespace
}  // namespace touchstone
