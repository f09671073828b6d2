#include "scenarios/generators/worlds/world_family.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/check_claims.h"
#include "scenarios/scenario_file.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

constexpr std::uint64_t kSeed = 20;

/** Returns the world as a scenario that can be written. */
WorldScenario Named(WorldFamily family, std::uint64_t index) {
  const std::string name(NameOf(family));
  WorldScenario scenario = GenerateWorld(family, kSeed, index);
  scenario.id = name;
  scenario.source = name;
  return scenario;
}

class GenerateWorldFamily : public ::testing::TestWithParam<WorldFamily> {};

TEST_P(GenerateWorldFamily, ReturnsValidWorldsWhoseClaimsHaveNoErrors) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const WorldScenario scenario = Named(GetParam(), i);
    for (const Fault& fault : FaultsOf(scenario)) {
      ADD_FAILURE() << "world " << i << ": " << fault.where << ' ' << fault.what;
    }
    EXPECT_FALSE(scenario.claims.empty());
    for (const Diagnostic& error : ErrorsOfClaims(scenario)) {
      ADD_FAILURE() << ToString(error) << '\n' << WriteScenario(scenario);
    }
    if (HasFailure()) return;
  }
}

TEST_P(GenerateWorldFamily, ReturnsSmallAndShortWorlds) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const World world = Named(GetParam(), i).world;
    EXPECT_LE(world.bodies.size() + world.particles.size(), 7U);
    EXPECT_LE(world.steps * world.dt, 2);
    EXPECT_LE(world.steps / world.sample_every, 120);
  }
}

TEST_P(GenerateWorldFamily, ReturnsWorldsThatAFileKeepsBitForBit) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const std::string text = WriteScenario(Named(GetParam(), i));
    const ReadResult read = ReadScenario(text, "generated");
    ASSERT_TRUE(read.world) << ToString(read.diagnostics.at(0)) << '\n' << text;
    EXPECT_EQ(WriteScenario(*read.world), text);
  }
}

TEST_P(GenerateWorldFamily, ReturnsTheSameWorldForTheSameSeedAndIndexOnly) {
  std::set<std::string> worlds;
  for (std::uint64_t i = 0; i < 100; ++i) {
    worlds.insert(WriteScenario(Named(GetParam(), i)));
    worlds.insert(WriteScenario(Named(GetParam(), i)));
  }
  EXPECT_EQ(worlds.size(), 100U);
}

INSTANTIATE_TEST_SUITE_P(Families, GenerateWorldFamily,
                         ::testing::ValuesIn(AllWorldFamilies()), [](const auto& family) {
                           return std::string(NameOf(family.param));
                         });

/** Returns the numbers of worlds of a family by the laws that they claim, and by those
 with the number of their subjects: "pendulum", "pendulum of 2". */
std::map<std::string, int> LawsOf(WorldFamily family) {
  std::map<std::string, int> laws;
  for (std::uint64_t i = 0; i < 200; ++i) {
    for (const Claim& claim : GenerateWorld(family, kSeed, i).claims) {
      ++laws[claim.law];
      ++laws[claim.law + " of " + std::to_string(claim.about.size())];
    }
  }
  return laws;
}

TEST(WorldFamily, ClaimsTheLawsOfItsKindsOfWorld) {
  using testing::Contains;
  using testing::Key;
  for (const auto& [family, laws] : std::map<WorldFamily, std::set<std::string>>{
           {WorldFamily::kDrops, {"bounce_series", "coulomb_cone"}},
           {WorldFamily::kImpacts,
            {"sphere_impact of 1", "sphere_impact of 2", "corner_impact"}},
           {WorldFamily::kSlides, {"incline", "slide_to_stop", "slip_to_roll", "rolls"}},
           {WorldFamily::kRods, {"pendulum of 1", "pendulum of 2", "conserves_energy"}},
           {WorldFamily::kStacks, {"rests", "stack_support"}},
           {WorldFamily::kLinkages, {"joint_length"}},
           {WorldFamily::kBars, {"coulomb_cone", "conserves_momentum"}},
           {WorldFamily::kStepLengths, {"ballistic", "torque_free", "rests"}}}) {
    const std::map<std::string, int> claimed = LawsOf(family);
    for (const std::string& law : laws) {
      EXPECT_THAT(claimed, Contains(Key(law))) << NameOf(family);
    }
  }
}

// On a slope the ratio of friction to its threshold decides: it is on both sides of 1, at
// all distances down to a thousandth, and never nearer.
TEST(WorldFamily, SlidesAreOnBothSidesOfTheThresholdAndNotOnIt) {
  int boxes = 0;
  int below = 0;
  double nearest = 1;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const WorldScenario scenario = GenerateWorld(WorldFamily::kSlides, kSeed, i);
    const RigidBody& body = scenario.world.bodies.back();
    if (scenario.claims.at(0).law != "incline") continue;
    if (!std::holds_alternative<Box>(body.placed.shape)) continue;
    const Eigen::Matrix3d& R = scenario.world.bodies.front().placed.X_WB.R_WB;
    const double press = -R.col(2).dot(scenario.world.gravity_W);
    const double along = (scenario.world.gravity_W + press * R.col(2)).norm();
    const double ratio = body.friction / (along / press);
    ++boxes;
    if (ratio < 1) ++below;
    nearest = std::min(nearest, std::abs(ratio - 1));
  }
  EXPECT_GT(boxes, 100);
  EXPECT_GT(below, boxes / 3);
  EXPECT_LT(below, boxes * 2 / 3);
  EXPECT_GT(nearest, 0.999e-3);
  EXPECT_LT(nearest, 2e-3);
}

TEST(WorldFamily, MassRatiosReachTenThousand) {
  double largest = 1;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const World world = GenerateWorld(WorldFamily::kMassRatios, kSeed, i).world;
    std::vector<double> masses;
    for (const RigidBody& body : world.bodies)
      if (body.mass > 0) masses.push_back(body.mass);
    for (const Particle& particle : world.particles) masses.push_back(particle.mass);
    const auto [least, most] = std::minmax_element(masses.begin(), masses.end());
    largest = std::max(largest, *most / *least);
  }
  EXPECT_GT(largest, 5e3);
  EXPECT_LT(largest, 1.001e4);
}

// The measure of islands that hold rods and contacts: a generator that throws everything
// past the ground, or makes no loops, would measure nothing.
TEST(WorldFamily, LinkagesAreTreesAndLoopsOfUnequalBodies) {
  int loops = 0;
  int to_world = 0;
  int loose = 0;
  int bars = 0;
  double largest = 1;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const World world = GenerateWorld(WorldFamily::kLinkages, kSeed, i).world;
    const auto rods = static_cast<int>(world.joints.size());
    const auto fixed = static_cast<int>(std::count_if(
        world.joints.begin(), world.joints.end(),
        [](const auto& joint) { return joint.A.on == AnchorKind::kWorld; }));
    // The ground is the last body.
    const bool has_loose_body =
        std::any_of(world.bodies.begin(), world.bodies.end(),
                    [](const RigidBody& body) { return body.name == "loose_body"; });
    const int linked = static_cast<int>(world.bodies.size()) - (has_loose_body ? 2 : 1);
    EXPECT_GE(linked, 2);
    EXPECT_LE(linked, 6);
    EXPECT_GE(rods - fixed, linked - 1);
    loops += rods - fixed > linked - 1;
    to_world += fixed > 0;
    loose += has_loose_body;
    double lightest = 1e9;
    double heaviest = 0;
    for (const RigidBody& body : world.bodies) {
      if (body.mass == 0) continue;
      lightest = std::min(lightest, body.mass);
      heaviest = std::max(heaviest, body.mass);
      const auto* box = std::get_if<Box>(&body.placed.shape);
      bars += box != nullptr &&
              box->half_extents.maxCoeff() > 10 * box->half_extents.minCoeff();
    }
    largest = std::max(largest, heaviest / lightest);
  }
  EXPECT_GT(loops, 200);
  EXPECT_GT(to_world, 100);
  EXPECT_GT(loose, 200);
  EXPECT_GT(bars, 100);
  EXPECT_GT(largest, 50);
  EXPECT_LT(largest, 100.1);
}

// Bodies that overlapped at the start would be moved apart, which does work.
TEST(WorldFamily, LinkagesStartApartAndStretchNoRod) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const World world = GenerateWorld(WorldFamily::kLinkages, kSeed, i).world;
    for (std::size_t a = 0; a + 1 < world.bodies.size(); ++a) {
      for (std::size_t b = a + 1; b + 1 < world.bodies.size(); ++b) {
        const Body& A = world.bodies[a].placed;
        const Body& B = world.bodies[b].placed;
        EXPECT_GT((A.X_WB.p_WB - B.X_WB.p_WB).norm(),
                  BoundingRadius(A.shape) + BoundingRadius(B.shape))
            << i;
      }
    }
    const auto velocity_of = [&](const Anchor& anchor) -> Eigen::Vector3d {
      if (anchor.on == AnchorKind::kWorld) return Eigen::Vector3d::Zero();
      const RigidBody& body = world.bodies[static_cast<std::size_t>(anchor.index)];
      return body.v_WB + body.w_WB.cross(body.placed.X_WB.R_WB * anchor.point);
    };
    for (const DistanceJoint& joint : world.joints) {
      const Eigen::Vector3d d = StartOf(world, joint.B) - StartOf(world, joint.A);
      const Eigen::Vector3d u = velocity_of(joint.B) - velocity_of(joint.A);
      EXPECT_NEAR(d.dot(u), 0, 1e-12 * (1 + d.norm() * u.norm())) << i;
    }
  }
}

TEST(WorldFamily, IsFoundByItsName) {
  for (const WorldFamily family : AllWorldFamilies())
    EXPECT_EQ(WorldFamilyNamed(NameOf(family)), family);
  EXPECT_FALSE(WorldFamilyNamed("flights"));
}

}  // namespace
}  // namespace touchstone
