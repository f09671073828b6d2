#include "scenarios/generators/generate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "scenarios/cube_rotations.h"
#include "scenarios/scenario_file.h"
#include "scenarios/validate.h"
#include "tests/scenarios/same_bits.h"

namespace touchstone {
namespace {

constexpr std::uint64_t kSeed = 20;

std::vector<std::pair<ShapeKind, ShapeKind>> AllPairs() {
  std::vector<std::pair<ShapeKind, ShapeKind>> pairs;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const auto pair = std::pair(static_cast<ShapeKind>(a), static_cast<ShapeKind>(b));
      if (pair != std::pair(ShapeKind::kHalfSpace, ShapeKind::kHalfSpace)) {
        pairs.push_back(pair);
      }
    }
  }
  return pairs;
}

/** Returns the query as a file, which preserves every bit of it. */
std::string Written(const ContactQuery& query) {
  Scenario scenario;
  scenario.id = "generated";
  scenario.title = scenario.source = "-";
  scenario.name_A = "A";
  scenario.name_B = "B";
  scenario.contact = query;
  return WriteScenario(scenario);
}

class GenerateFamily : public ::testing::TestWithParam<Family> {};

TEST_P(GenerateFamily, ReturnsValidQueriesForEveryPair) {
  for (const auto& [a, b] : AllPairs()) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const ContactQuery query = Generate(GetParam(), a, b, kSeed, i);
      EXPECT_EQ(KindOf(query.A.shape), a);
      EXPECT_EQ(KindOf(query.B.shape), b);
      for (const Fault& fault : FaultsOf(query)) {
        ADD_FAILURE() << fault.where << ' ' << fault.what << '\n' << Written(query);
      }
    }
  }
}

TEST_P(GenerateFamily, ReturnsTheSameQueryAtEveryCall) {
  for (const auto& [a, b] : AllPairs()) {
    const ContactQuery later = Generate(GetParam(), a, b, kSeed, 9);
    const ContactQuery first = Generate(GetParam(), a, b, kSeed, 2);
    EXPECT_TRUE(SameBits(first, Generate(GetParam(), a, b, kSeed, 2)));
    EXPECT_TRUE(SameBits(later, Generate(GetParam(), a, b, kSeed, 9)));
  }
}

TEST_P(GenerateFamily, ReturnsADifferentQueryForEverySeedAndIndex) {
  std::set<std::string> questions;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    for (std::uint64_t i = 0; i < 30; ++i) {
      questions.insert(
          Written(Generate(GetParam(), ShapeKind::kBox, ShapeKind::kCone, seed, i)));
    }
  }
  EXPECT_EQ(questions.size(), 900U);
}

/** Returns the 64-bit FNV-1a hash (Fowler, Noll & Vo) of the text of queries of all
 * pairs.
 */
std::uint64_t Fingerprint(Family family) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const auto& [a, b] : AllPairs()) {
    for (std::uint64_t i = 0; i < 10; ++i) {
      for (const char c : Written(Generate(family, a, b, kSeed, i))) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
      }
    }
  }
  return hash;
}

TEST_P(GenerateFamily, ReturnsTheSameQueriesOnEveryMachine) {
  // Golden values: equal on g++ 12 and clang 14, at -O1 and -O3 -march=native, x86-64. A
  // change of a generator changes its value here, and the queries of every published
  // sweep.
  const std::uint64_t expected[] = {
      0x51ab84581f5ec1fb, 0xce72a90dfc59f5ae, 0x3cd8373c6ca392e6, 0xd91a206f238ba78e,
      0x5e7f207b57ea519,  0x4634ffcd9874dc3f, 0xdcd83c5b43a7fca3, 0xa8f3418b098580d1,
      0xe500f14da20ba63,  0xa6450e49cd1e84c2, 0xa46038693794ce56, 0x331e370a4f58db58,
      0x8b6e2568e2ea2338};
  EXPECT_EQ(Fingerprint(GetParam()), expected[static_cast<std::size_t>(GetParam())])
      << std::hex << "0x" << Fingerprint(GetParam());
}

INSTANTIATE_TEST_SUITE_P(, GenerateFamily, ::testing::ValuesIn(AllFamilies()),
                         [](const auto& family) {
                           return std::string(NameOf(family.param));
                         });

/** The kinds for which the referee decides touching at any pair and pose. */
constexpr ShapeKind kDecided[] = {ShapeKind::kSphere, ShapeKind::kBox,
                                  ShapeKind::kCapsule, ShapeKind::kHalfSpace};

struct Tally {
  int touching = 0;
  int apart = 0;
  int undecided = 0;
};

Tally TallyOf(Family family, ShapeKind a, ShapeKind b) {
  Tally tally;
  for (std::uint64_t i = 0; i < 200; ++i) {
    switch (ComputeContactTruth(Generate(family, a, b, kSeed, i)).touching) {
      case Touching::kTouching:
        ++tally.touching;
        break;
      case Touching::kApart:
        ++tally.apart;
        break;
      case Touching::kUndecided:
        ++tally.undecided;
        break;
    }
  }
  return tally;
}

TEST_P(GenerateFamily, TouchesInTheExpectedFractionOfItsQueries) {
  // Expected fraction: 0.6 in the family random, 1/2 in touching, 2/3 in the others; a
  // deep query always touches. With 200 draws the fraction has a standard deviation of
  // 0.035. In random, shapes that are separated along another direction than the drawn
  // one reduce it by a further tenth.
  double share = 2.0 / 3;
  if (GetParam() == Family::kRandom) share = 0.6;
  if (GetParam() == Family::kTouching) share = 0.5;
  if (GetParam() == Family::kGrazing) share = 1.0 / 3;
  const bool is_deep = GetParam() == Family::kDeep;
  for (const ShapeKind a : kDecided) {
    for (const ShapeKind b : kDecided) {
      if (a == ShapeKind::kHalfSpace && b == ShapeKind::kHalfSpace) continue;
      const Tally tally = TallyOf(GetParam(), a, b);
      const std::string pair = std::string(NameOf(a)) + " and " + std::string(NameOf(b));
      const double hits = tally.touching / 200.0;
      EXPECT_GE(hits, is_deep ? 1 : share - 0.14) << pair;
      EXPECT_LE(hits, is_deep ? 1 : share + 0.14) << pair;
      // A gap of 1e-14 m is above the rounding of some poses and below that of others.
      // Three to six of the thirteen powers of two of `grazing` are below them.
      if (GetParam() == Family::kGrazing) {
        EXPECT_GE(tally.undecided, 200 * 2 / 13) << pair;
        EXPECT_LE(tally.undecided, 200 * 7 / 13) << pair;
        EXPECT_GE(tally.apart, 200 / 5) << pair;
      } else {
        EXPECT_LE(tally.undecided, GetParam() == Family::kTouching ? 20 : 0) << pair;
      }
    }
  }
}

TEST(GenerateTouching, HasTheDrawnSeparation) {
  // Spheres have one normal, so the drawn overlap is the depth. With 1000 queries, each
  // of the 13 decades of gaps has 77 on average, half of each sign.
  std::map<std::pair<int, bool>, int> per_decade;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const ContactTruth truth = ComputeContactTruth(
        Generate(Family::kTouching, ShapeKind::kSphere, ShapeKind::kSphere, kSeed, i));
    const double separation = (truth.separation.lo + truth.separation.hi) / 2;
    const auto decade = static_cast<int>(std::floor(std::log10(std::abs(separation))));
    ++per_decade[{decade, separation < 0}];
  }
  // Below 1e-13 m the rounding of the pose blurs the decades.
  for (int decade = -13; decade < -1; ++decade) {
    EXPECT_GT((per_decade[{decade, true}]), 15) << decade;
    EXPECT_GT((per_decade[{decade, false}]), 15) << decade;
  }
}

TEST(GenerateNearParallel, RotatesBByEveryDecadeOfAngles) {
  // |R_AB − 1| in the Frobenius norm is √8 sin(θ/2), which is √2 θ for small θ.
  std::map<int, int> per_decade;
  for (std::uint64_t i = 0; i < 1600; ++i) {
    const ContactQuery query =
        Generate(Family::kNearParallel, ShapeKind::kBox, ShapeKind::kBox, kSeed, i);
    const Eigen::Matrix3d R_AB = query.A.X_WB.R_WB.transpose() * query.B.X_WB.R_WB;
    const double angle = (R_AB - Eigen::Matrix3d::Identity()).norm() / std::sqrt(2.0);
    EXPECT_LT(angle, 1);
    ++per_decade[static_cast<int>(std::floor(std::log10(std::max(angle, 1e-17))))];
  }
  // The average is 100 per decade. Angles below 1e-14 are lost in the rounding of the
  // product.
  for (int decade = -14; decade < 0; ++decade)
    EXPECT_GT(per_decade[decade], 60) << decade;
}

TEST(GenerateSymmetries, CombinesEveryRotationWithEveryPerturbation) {
  // If A is not rotated, R_WB is the rotation times the perturbation, up to rounding.
  int unturned = 0;
  for (std::uint64_t i = 0; i < 24 * 15; ++i) {
    const ContactQuery query =
        Generate(Family::kSymmetries, ShapeKind::kBox, ShapeKind::kBox, kSeed, i);
    if (query.A.X_WB.R_WB != Eigen::Matrix3d::Identity()) continue;
    ++unturned;
    const Eigen::Matrix3d symmetry = CubeRotation(static_cast<int>(i % 24));
    const double angle = std::pow(10.0, static_cast<double>(i / 24) - 15);
    // |P − 1| is at most the angle; entries in a sum with 1 are rounded to 2^-53.
    EXPECT_LE((query.B.X_WB.R_WB - symmetry).cwiseAbs().maxCoeff(), 1.001 * angle) << i;
    EXPECT_GT((query.B.X_WB.R_WB - symmetry).cwiseAbs().maxCoeff(), 0.2 * angle) << i;
  }
  EXPECT_GT(unturned, 24 * 15 / 3);
}

TEST(GenerateMixedSizes, HasEveryDecadeOfRatios) {
  std::map<int, int> per_decade;
  for (std::uint64_t i = 0; i < 1200; ++i) {
    const ContactQuery query =
        Generate(Family::kMixedSizes, ShapeKind::kSphere, ShapeKind::kSphere, kSeed, i);
    const double ratio =
        std::get<Sphere>(query.A.shape).radius / std::get<Sphere>(query.B.shape).radius;
    ++per_decade[static_cast<int>(std::floor(std::log10(ratio)))];
  }
  // The average is 100 for each sign of the logarithm; radii of 0.2 to 1.2 m blur the
  // decades, so those at the ends are fewer.
  for (int decade = -6; decade < 6; ++decade) EXPECT_GT(per_decade[decade], 50) << decade;
}

TEST(GenerateFarFromOrigin, IsUpTo10000KilometresAway) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const ContactQuery query =
        Generate(Family::kFarFromOrigin, ShapeKind::kBox, ShapeKind::kBox, kSeed, i);
    const double distance = query.A.X_WB.p_WB.norm();
    EXPECT_GT(distance, 99);
    EXPECT_LT(distance, 1.001e7);
    EXPECT_LT((query.B.X_WB.p_WB - query.A.X_WB.p_WB).norm(), 5);
  }
}

TEST(GenerateLargeHulls, HasUpTo1000VerticesAndAboutTwoThirdsTouch) {
  std::size_t most = 0;
  int touching = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const ContactQuery query = Generate(Family::kLargeHulls, ShapeKind::kConvexHull,
                                        ShapeKind::kSphere, kSeed, i);
    most = std::max(most, std::get<ConvexHull>(query.A.shape).vertices.size());
    if (ComputeContactTruth(query).touching == Touching::kTouching) ++touching;
  }
  EXPECT_EQ(most, 1000U);
  // With 60 draws the fraction has a standard deviation of 0.06.
  EXPECT_NEAR(touching / 60.0, 2.0 / 3, 0.18);
}

TEST(FamilyNames, AreDistinctAndFoundAgain) {
  std::set<std::string_view> names;
  for (const Family family : AllFamilies()) {
    EXPECT_EQ(FamilyNamed(NameOf(family)), family);
    names.insert(NameOf(family));
  }
  EXPECT_EQ(names.size(), AllFamilies().size());
  EXPECT_EQ(FamilyNamed("no_family"), std::nullopt);
}

}  // namespace
}  // namespace touchstone
