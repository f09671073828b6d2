#include "reports/worlds/study/world_variants.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/worlds/validate_world.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

World Hanging() {
  World world;
  world.bodies = {BodyOf("post", Box{{0.1, 1, 0.1}}, 0, {0, 1, 0}),
                  BodyOf("bob", Box{{0.1, 0.2, 0.3}}, 2, {1.5, 2, 0.3})};
  world.bodies[1].placed.X_WB =
      Pose::FromQuaternion({1.5, 2, 0.3}, Eigen::Quaterniond(0.4, -0.2, 0.8, 0.4));
  world.joints = {{{AnchorKind::kBody, 0, {0.1, 0.9, 0}},
                   {AnchorKind::kBody, 1, {-0.1, 0.2, 0.3}},
                   0}};
  world.joints[0].length =
      (StartOf(world, world.joints[0].A) - StartOf(world, world.joints[0].B)).norm();
  world.springs = {{{AnchorKind::kWorld, -1, {2, 3, 1}},
                    {AnchorKind::kBody, 1, {0.1, 0, 0}},
                    40,
                    0.5,
                    0.7}};
  world.pushes = {{1, 0.1, {0.1, 0, 0.2}, {1, -2, 0.5}}};
  return world;
}

std::vector<MeasureKind> KindsOf(const World& world) {
  std::vector<MeasureKind> kinds;
  for (const WorldVariant& variant : VariantsOf(world)) kinds.push_back(variant.measure);
  return kinds;
}

TEST(VariantsOf, AreTurnedMovedMirroredReorderedAndHeavier) {
  EXPECT_THAT(
      KindsOf(Hanging()),
      ElementsAre(MeasureKind::kHeading, MeasureKind::kTranslation, MeasureKind::kMirror,
                  MeasureKind::kPermutation, MeasureKind::kMassScaling));
}

TEST(VariantsOf, AreWorldsThatCanBeSimulated) {
  for (const WorldVariant& variant : VariantsOf(Hanging()))
    EXPECT_THAT(FaultsOf(variant.world), IsEmpty()) << NameOf(variant.measure);
}

TEST(VariantsOf, AreNotTurnedWithAClothNorMirroredWithAHull) {
  World cloth;
  cloth.cloths.emplace_back();
  EXPECT_THAT(KindsOf(cloth),
              ElementsAre(MeasureKind::kTranslation, MeasureKind::kMassScaling));
  World hull;
  hull.bodies = {BodyOf("stone", ConvexHull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                        1, {0, 0, 0})};
  EXPECT_THAT(KindsOf(hull), ElementsAre(MeasureKind::kHeading, MeasureKind::kTranslation,
                                         MeasureKind::kMassScaling));
}

TEST(VariantsOf, MapTheirAnchors) {
  const World world = Hanging();
  for (const WorldVariant& variant : VariantsOf(world)) {
    const auto expect_at_place = [&](const Anchor& of_world, const Anchor& of_variant) {
      const Eigen::Vector3d place = variant.S * StartOf(world, of_world) + variant.offset;
      EXPECT_LE((StartOf(variant.world, of_variant) - place).norm(), 1e-14)
          << NameOf(variant.measure);
    };
    expect_at_place(world.joints[0].A, variant.world.joints[0].A);
    expect_at_place(world.joints[0].B, variant.world.joints[0].B);
    expect_at_place(world.springs[0].A, variant.world.springs[0].A);
    expect_at_place(world.springs[0].B, variant.world.springs[0].B);
  }
}

TEST(VariantsOf, MapPointAndDirectionOfAnImpulse) {
  const World world = Hanging();
  const auto place = [](const World& w) {
    const Push& push = w.pushes[0];
    const Pose& X_WB = w.bodies[static_cast<std::size_t>(push.body)].placed.X_WB;
    return Eigen::Vector3d(X_WB.p_WB + X_WB.R_WB * push.p_BoP);
  };
  for (const WorldVariant& variant : VariantsOf(world)) {
    EXPECT_LE((place(variant.world) - variant.S * place(world) - variant.offset).norm(),
              1e-14)
        << NameOf(variant.measure);
    const double factor = variant.measure == MeasureKind::kMassScaling ? 3 : 1;
    EXPECT_LE(
        (variant.world.pushes[0].J_W - factor * variant.S * world.pushes[0].J_W).norm(),
        1e-14);
  }
}

TEST(SeenInWorld, MapsTheStartOfAVariantBackToThatOfTheWorld) {
  const World world = Hanging();
  const auto start = [](const World& w) {
    return Sampled(w, [&](double) {
      WorldState state;
      for (const RigidBody& body : w.bodies)
        state.bodies.push_back({body.placed.X_WB.p_WB,
                                Eigen::Quaterniond(body.placed.X_WB.R_WB), body.v_WB,
                                body.w_WB});
      return state;
    });
  };
  World moving = world;
  moving.bodies[1].v_WB = {0.3, -1, 0.2};
  moving.bodies[1].w_WB = {1, 2, -0.7};
  const WorldState truth = start(moving).samples[0];
  for (const WorldVariant& variant : VariantsOf(moving)) {
    const WorldState seen = SeenInWorld(variant, start(variant.world)).samples[0];
    for (std::size_t i = 0; i < truth.bodies.size(); ++i) {
      const BodyState& a = truth.bodies[i];
      const BodyState& b = seen.bodies[i];
      EXPECT_LE((a.p_WB - b.p_WB).norm(), 1e-14) << NameOf(variant.measure);
      EXPECT_LE((a.v_WB - b.v_WB).norm(), 1e-14) << NameOf(variant.measure);
      EXPECT_LE((a.w_WB - b.w_WB).norm(), 1e-14) << NameOf(variant.measure);
      EXPECT_LE(a.q_WB.angularDistance(b.q_WB), 1e-7) << NameOf(variant.measure);
    }
  }
}

TEST(ClaimsOf, MapTheirDirections) {
  const World world = Hanging();
  Claim along;
  along.law = "conserves_momentum";
  along.numbers = {{"x", 3}, {"z", 4}, {"expected_momentum", 0.7}};
  Claim other;
  other.law = "rests";
  other.numbers = {{"from", 2}};
  for (const WorldVariant& variant : VariantsOf(world)) {
    const std::vector<Claim> claims = ClaimsOf(variant, {along, other});
    const Eigen::Vector3d turned = variant.S * Eigen::Vector3d(3, 0, 4);
    EXPECT_DOUBLE_EQ(claims[0].numbers.at("x"), turned.x()) << NameOf(variant.measure);
    EXPECT_DOUBLE_EQ(claims[0].numbers.at("z"), turned.z()) << NameOf(variant.measure);
    EXPECT_EQ(claims[0].numbers.at("expected_momentum"), 0.7);
    EXPECT_EQ(claims[1].numbers, other.numbers);
  }
}

}  // namespace
}  // namespace touchstone
