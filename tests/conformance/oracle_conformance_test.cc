// The contract of an oracle, stated once and tested for every oracle. An adapter is
// complete when it is listed here and passes.

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"
#include "tests/conformance/contract.h"
#include "tests/oracles/constructed_contact.h"

namespace touchstone {
namespace {

using enum ShapeKind;
using Cell = std::array<ShapeKind, 2>;

const OracleRegistry& Registry() {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry;
}

/** Pairs of kinds, in either order: all with one of `shapes`, and `pairs`. */
struct Pairs {
  std::vector<ShapeKind> shapes;
  std::vector<Cell> pairs;

  bool Contain(ShapeKind a, ShapeKind b) const {
    return std::any_of(shapes.begin(), shapes.end(),
                       [&](ShapeKind kind) { return kind == a || kind == b; }) ||
           std::any_of(pairs.begin(), pairs.end(), [&](const Cell& pair) {
             return pair == Cell{a, b} || pair == Cell{b, a};
           });
  }
};

constexpr Cell kTwoHalfSpaces = {kHalfSpace, kHalfSpace};

const Pairs kOnlySpheresAndBoxes = {{kCapsule, kCylinder, kCone, kConvexHull, kHalfSpace},
                                    {}};
const Pairs kWorldsOnly = {
    {kSphere, kBox, kCapsule, kCylinder, kCone, kConvexHull, kHalfSpace}, {}};
const Pairs kConvexOnly = {{kHalfSpace}, {}};
const Pairs kAllButTwoHalfSpaces = {{}, {kTwoHalfSpaces}};

/** All pairs that an oracle does not support. */
struct Unsupported {
  std::string_view oracle;
  Pairs pairs;
};

const std::vector<Unsupported> kUnsupported = {
    {"bullet", kAllButTwoHalfSpaces},
    {"bullet/gjk", kConvexOnly},
    {"bullet_float", kAllButTwoHalfSpaces},
    {"bullet_float/gjk", kConvexOnly},
    {"cookbook", kOnlySpheresAndBoxes},
    {"cookbook/batch",
     {{kCapsule, kCylinder, kCone, kConvexHull, kHalfSpace}, {{kSphere, kBox}}}},
    {"cookbook/sleeping", kWorldsOnly},
    {"dart", kOnlySpheresAndBoxes},
    {"fcl/collide", kAllButTwoHalfSpaces},
    {"fcl/collide_indep", kAllButTwoHalfSpaces},
    {"fcl/distance", kAllButTwoHalfSpaces},
    {"fcl/distance_indep", kAllButTwoHalfSpaces},
    {"fcl/signed_distance", kAllButTwoHalfSpaces},
    {"fcl/signed_distance_indep", kAllButTwoHalfSpaces},
    {"libccd/epa", kConvexOnly},
    {"libccd/mpr", kConvexOnly},
    {"mujoco", {{kCone, kConvexHull}, {kTwoHalfSpaces}}},
    {"mujoco/rk4", kWorldsOnly},
    {"ode", {{kCone}, {kTwoHalfSpaces}}},
    {"ode/quick", kWorldsOnly},
    {"printed:none", kOnlySpheresAndBoxes},
};

/** Pairs for which an engine returns a wrong known answer. The fault is asserted: once
 the engine is right, the pair must be removed from its row. The other clauses are not
 tested for a pair in this table. */
struct EngineFault {
  std::string_view oracle;
  Pairs pairs;
  std::string_view why;
};

/* The pairs for which GST_INDEP has no closed form. */
const Pairs kIndepEpa = {{},
                         {{kSphere, kCone},
                          {kSphere, kConvexHull},
                          {kBox, kCapsule},
                          {kBox, kCylinder},
                          {kBox, kCone},
                          {kBox, kConvexHull},
                          {kCapsule, kCapsule},
                          {kCapsule, kCylinder},
                          {kCapsule, kCone},
                          {kCapsule, kConvexHull},
                          {kCylinder, kCylinder},
                          {kCylinder, kCone},
                          {kCylinder, kConvexHull},
                          {kCone, kCone},
                          {kCone, kConvexHull},
                          {kConvexHull, kConvexHull}}};

const std::vector<EngineFault> kEngineFaults = {
    {"ode",
     {{}, {{kBox, kCylinder}}},
     "multiplies the radius by sqrt(1 - cos^2) as the sine of the angle between cylinder "
     "and box axes, which keeps half the digits near 0 (collision_cylinder_box.cpp)"},
    {"ode",
     {{}, {{kCylinder, kConvexHull}}},
     "for a direction along the cylinder's axis its support function normalises the "
     "rounding error of the radial part, which may point along the axis: false contacts "
     "up to a radius beyond the end (ccdSupportCyl in collision_libccd.cpp)"},
    {"fcl/collide", {{}, {{kSphere, kCapsule}}}, "puts the contact outside the sphere"},
    {"fcl/collide_indep",
     {{}, {{kSphere, kCapsule}}},
     "puts the contact outside the sphere"},
    {"fcl/collide_indep", kIndepEpa,
     "its EPA returns the depth with the wrong sign and the normal in a body frame"},
    {"fcl/distance", kConvexOnly,
     "calls a null support function for the half-space: SIGSEGV"},
    {"fcl/distance",
     {{}, {{kBox, kCapsule}, {kCapsule, kConvexHull}}},
     "stops when one iteration gains less than distance_tolerance, "
     "which does not bound the error"},
    {"fcl/signed_distance", kConvexOnly,
     "calls a null support function for the half-space: SIGSEGV"},
    {"fcl/signed_distance",
     {{},
      {{kSphere, kSphere},
       {kSphere, kBox},
       {kSphere, kCapsule},
       {kSphere, kConvexHull},
       {kBox, kCapsule},
       {kCapsule, kCapsule},
       {kCapsule, kConvexHull}}},
     "stops when one iteration gains less than distance_tolerance, "
     "which does not bound the error"},
    {"fcl/distance_indep",
     {{}, {{kSphere, kHalfSpace}, {kCapsule, kHalfSpace}}},
     "its distances are off by a millimetre, and it reports overlap as apart"},
    {"fcl/signed_distance_indep", kIndepEpa, "an assertion in distance-inl.h aborts it"},
    {"fcl/signed_distance_indep",
     {{}, {{kSphere, kHalfSpace}, {kCapsule, kHalfSpace}}},
     "its distances are off by a millimetre, and it reports overlap as apart"},
    {"libccd/epa",
     {{},
      {{kSphere, kSphere},
       {kSphere, kBox},
       {kSphere, kCapsule},
       {kSphere, kCylinder},
       {kSphere, kCone},
       {kSphere, kConvexHull},
       {kBox, kCapsule},
       {kCapsule, kCapsule},
       {kCapsule, kCylinder},
       {kCapsule, kCone},
       {kCapsule, kConvexHull}}},
     "its EPA stops on round shapes far from epa_tolerance (danfis/libccd#44)"},
    {"libccd/epa",
     {{}, {{kBox, kBox}, {kBox, kConvexHull}}},
     "puts the contact centimetres off the overlap"},
    {"mujoco",
     {{}, {{kBox, kBox}}},
     "returns half the depth along the normal of a face (engine_collision_box.c)"},
    {"mujoco",
     {{}, {{kCylinder, kHalfSpace}}},
     "for an upright cylinder it normalises the rounding error of the radial part of the "
     "plane's normal, which may point along the axis: the contacts are lost "
     "(mjc_PlaneCylinder)"},
};

const EngineFault* FaultOf(std::string_view oracle, ShapeKind a, ShapeKind b) {
  for (const EngineFault& fault : kEngineFaults) {
    if (fault.oracle == oracle && fault.pairs.Contain(a, b)) return &fault;
  }
  return nullptr;
}

/** Returns `name` as the name of a test, with letters, digits and underscores only. */
std::string TestName(std::string_view name) {
  std::string test_name(name);
  std::replace_if(
      test_name.begin(), test_name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return test_name;
}

/* All oracles, with the specimen without errata for the printed engine: the errata of the
 other specimens violate the contract on purpose. */
std::vector<std::string> OracleNames() {
  std::vector<std::string> names;
  for (const Oracle* oracle : Registry().All()) {
    const std::string& name = oracle->info().name;
    names.push_back(name == "printed" ? "printed:none" : name);
  }
  return names;
}

class OracleConformance : public testing::TestWithParam<std::string> {
 protected:
  const Oracle& oracle() const { return *Registry().Find(GetParam()); }
};

TEST_P(OracleConformance, StatesExactlyWhatItDoesNotSupportAndWhy) {
  const auto row = std::find_if(kUnsupported.begin(), kUnsupported.end(),
                                [](const auto& r) { return r.oracle == GetParam(); });
  ASSERT_NE(row, kUnsupported.end()) << "add a row, empty if it supports all pairs";
  for (int i = 0; i < kShapeKinds; ++i) {
    for (int j = 0; j < kShapeKinds; ++j) {
      const auto a = static_cast<ShapeKind>(i);
      const auto b = static_cast<ShapeKind>(j);
      SCOPED_TRACE(std::string(NameOf(a)) + " - " + std::string(NameOf(b)));
      const Capability& capability = oracle().info().For(a, b);
      EXPECT_NE(capability.supported, row->pairs.Contain(a, b));
      EXPECT_NE(capability.supported, capability.family.empty());
      EXPECT_EQ(capability.supported, capability.reason.empty());
      if (!capability.supported && Cell{a, b} != kTwoHalfSpaces) {
        const ContactAnswer answer = oracle().Answer(PutTogether(a, b, -2e-3).query);
        EXPECT_EQ(answer.status, AnswerStatus::kUnsupported);
        EXPECT_FALSE(answer.reason.empty());
      }
    }
  }
}

TEST_P(OracleConformance, IsAPureFunction) {
  EXPECT_EQ(Pure(oracle()), Breaches());
}

INSTANTIATE_TEST_SUITE_P(, OracleConformance, testing::ValuesIn(OracleNames()),
                         [](const auto& instance) { return TestName(instance.param); });

/** One oracle and a pair of kinds that it supports. */
struct PairCase {
  std::string oracle;
  ShapeKind a;
  ShapeKind b;
};

void PrintTo(const PairCase& c, std::ostream* out) {
  *out << c.oracle << ": " << NameOf(c.a) << " - " << NameOf(c.b);
}

/* Returns the supported pairs that have a fault of the engine, or those that have none.
 */
std::vector<PairCase> SupportedPairs(bool faulty) {
  std::vector<PairCase> cases;
  for (const std::string& name : OracleNames()) {
    const OracleInfo& info = Registry().Find(name)->info();
    for (int i = 0; i < kShapeKinds; ++i) {
      for (int j = i; j < kShapeKinds; ++j) {
        const auto a = static_cast<ShapeKind>(i);
        const auto b = static_cast<ShapeKind>(j);
        if (info.For(a, b).supported && (FaultOf(name, a, b) != nullptr) == faulty) {
          cases.push_back({name, a, b});
        }
      }
    }
  }
  return cases;
}

std::string NameOfCase(const testing::TestParamInfo<PairCase>& instance) {
  const PairCase& c = instance.param;
  return TestName(c.oracle) + "__" + std::string(NameOf(c.a)) + "__" +
         std::string(NameOf(c.b));
}

class PairConformance : public testing::TestWithParam<PairCase> {
 protected:
  Breaches Of(Breaches (*clause)(const Oracle&, ShapeKind, ShapeKind)) const {
    const PairCase& c = GetParam();
    return clause(*Registry().Find(c.oracle), c.a, c.b);
  }
};

TEST_P(PairConformance, ReturnsTheKnownAnswer) {
  EXPECT_EQ(Of(KnownAnswer), Breaches());
}

TEST_P(PairConformance, SwappingBodiesOnlyNegatesTheNormal) {
  EXPECT_EQ(Of(Swap), Breaches());
}

TEST_P(PairConformance, BodiesPushedApartByTheirDepthNoLongerTouch) {
  EXPECT_EQ(Of(PushApart), Breaches());
}

TEST_P(PairConformance, RigidMotionOnlyRotatesTheNormal) {
  EXPECT_EQ(Of(RigidMotion), Breaches());
}

INSTANTIATE_TEST_SUITE_P(, PairConformance, testing::ValuesIn(SupportedPairs(false)),
                         NameOfCase);

class EngineFaults : public PairConformance {};

TEST_P(EngineFaults, StillShow) {
  const PairCase& c = GetParam();
  EXPECT_FALSE(Of(KnownAnswer).empty())
      << "improved: remove the pair from the row with this fault: "
      << FaultOf(c.oracle, c.a, c.b)->why;
}

INSTANTIATE_TEST_SUITE_P(, EngineFaults, testing::ValuesIn(SupportedPairs(true)),
                         NameOfCase);

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
