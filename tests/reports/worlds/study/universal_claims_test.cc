#include "reports/worlds/study/universal_claims.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/judge_world.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/** Two balls above level ground that touches them by and by. */
WorldScenario TwoBalls() {
  WorldScenario scenario;
  scenario.id = "mine/two_balls";
  scenario.world.bodies = {BodyOf("near", Sphere{0.2}, 1, {0, 0.2, 0}),
                           BodyOf("far", Sphere{0.2}, 1, {2, 0.2, 0}), GroundOf()};
  scenario.world.steps = 50;
  return scenario;
}

std::vector<std::string> LawsOf(const WorldScenario& scenario) {
  std::vector<std::string> laws;
  for (const Claim& claim : UniversalClaims(scenario)) laws.push_back(claim.law);
  return laws;
}

const Claim* Find(const std::vector<Claim>& claims, const std::string& law) {
  const auto found = std::find_if(claims.begin(), claims.end(),
                                  [&](const Claim& claim) { return claim.law == law; });
  return found == claims.end() ? nullptr : &*found;
}

TEST(UniversalClaims, AWorldWithoutAnyClaimHasThoseThatApply) {
  EXPECT_THAT(LawsOf(TwoBalls()),
              UnorderedElementsAre("angular_momentum_balance", "contacts_on_bodies",
                                   "energy_never_rises", "momentum_balance",
                                   "moves_at_its_velocity", "never_passes_through",
                                   "never_penetrates"));
}

TEST(UniversalClaims, ConservesTheMomentaOfWhatTouchesNothingFixed) {
  WorldScenario scenario = TwoBalls();
  scenario.world.bodies.pop_back();
  EXPECT_NE(Find(UniversalClaims(scenario), "conserves_momentum"), nullptr);
  EXPECT_NE(Find(UniversalClaims(scenario), "conserves_angular_momentum"), nullptr);
  scenario.world.springs = {{{AnchorKind::kBody, 0, {0, 0, 0}}, {}, 1, 0, 1}};
  EXPECT_EQ(Find(UniversalClaims(scenario), "conserves_momentum"), nullptr);
}

TEST(UniversalClaims, RodsKeepTheirLength) {
  WorldScenario scenario = TwoBalls();
  EXPECT_EQ(Find(UniversalClaims(scenario), "joint_length"), nullptr);
  scenario.world.joints = {
      {{AnchorKind::kBody, 0, {0, 0, 0}}, {AnchorKind::kBody, 1, {0, 0, 0}}, 2}};
  const std::vector<Claim> claims = UniversalClaims(scenario);
  const Claim* rods = Find(claims, "joint_length");
  ASSERT_NE(rods, nullptr);
  EXPECT_THAT(rods->about, UnorderedElementsAre("near", "far"));
}

TEST(UniversalClaims, LeaveOutWhatDrivesAWorld) {
  WorldScenario scenario = TwoBalls();
  scenario.world.pushes.push_back({0, 0, {0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(Find(UniversalClaims(scenario), "energy_never_rises"), nullptr);
}

TEST(UniversalClaims, JudgeThePartsToWhichALawApplies) {
  WorldScenario scenario = TwoBalls();
  scenario.world.springs = {{{AnchorKind::kBody, 0, {0, 0, 0}}, {}, 1, 0, 1}};
  scenario.world.particles = {{"bob", {0, 5, 0}, {0, 0, 0}, 1}};
  const std::vector<Claim> claims = UniversalClaims(scenario);
  EXPECT_THAT(Find(claims, "momentum_balance")->about, ElementsAre("far"));
  EXPECT_THAT(Find(claims, "never_penetrates")->about, ElementsAre("near", "far"));
}

TEST(UniversalClaims, AClaimOfTheFileIsNotJudgedTwice) {
  WorldScenario scenario = TwoBalls();
  scenario.claims = {ClaimOf("never_penetrates", {}, {{"slack", 0.01}}),
                     ClaimOf("momentum_balance", {"near"})};
  const std::vector<Claim> claims = UniversalClaims(scenario);
  EXPECT_EQ(Find(claims, "never_penetrates"), nullptr);
  EXPECT_THAT(Find(claims, "momentum_balance")->about, ElementsAre("far"));
  scenario.claims[1].about = {"far", "near"};
  EXPECT_EQ(Find(UniversalClaims(scenario), "momentum_balance"), nullptr);
}

TEST(UniversalClaims, GrantTheSlackOfAClaimToItsOwnPairsOnly) {
  WorldScenario scenario = TwoBalls();
  scenario.claims = {ClaimOf("never_penetrates", {"near"}, {{"slack", 0.01}})};
  const std::vector<Claim> claims = UniversalClaims(scenario);
  EXPECT_THAT(Find(claims, "never_penetrates")->about, ElementsAre("far"));
  EXPECT_THAT(Find(claims, "never_penetrates")->claimed, ElementsAre("near"));
  EXPECT_THAT(Find(claims, "never_penetrates")->numbers, IsEmpty());
}

TEST(UniversalClaims, EnergyThatIsConservedNeverRises) {
  WorldScenario scenario = TwoBalls();
  scenario.claims = {ClaimOf("conserves_energy")};
  EXPECT_EQ(Find(UniversalClaims(scenario), "energy_never_rises"), nullptr);
  scenario.claims[0].about = {"near"};
  EXPECT_NE(Find(UniversalClaims(scenario), "energy_never_rises"), nullptr);
}

TEST(UniversalClaims, AClaimOfOneDirectionDoesNotReplaceTheWholeLaw) {
  WorldScenario scenario = TwoBalls();
  scenario.world.bodies.pop_back();
  scenario.claims = {ClaimOf("conserves_momentum", {}, {{"x", 1}})};
  EXPECT_NE(Find(UniversalClaims(scenario), "conserves_momentum"), nullptr);
  scenario.claims = {ClaimOf("conserves_momentum")};
  EXPECT_EQ(Find(UniversalClaims(scenario), "conserves_momentum"), nullptr);
}

std::vector<Finding> Judged(const WorldScenario& scenario,
                            const FakeSimulator::Function& motion) {
  const FakeSimulator engine("mine", motion);
  const Trajectory trajectory = engine.Simulate(scenario.world);
  return JudgeWorld({scenario, engine.info(), trajectory});
}

Trajectory AtRest(const World& world) {
  return Stepped(world, [](WorldState&) {});
}

TEST(UniversalLaws, PassAMotionThatRests) {
  const std::vector<Finding> findings = Judged(TwoBalls(), AtRest);
  EXPECT_TRUE(IsVerified(findings));
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.verdict, Verdict::kPass) << finding.proof;
    if (finding.measure == MeasureKind::kAnswering) continue;
    EXPECT_TRUE(finding.universal) << finding.law;
  }
}

TEST(UniversalLaws, FailAMotionThatSinksAndSayThatNoFileClaimsIt) {
  const std::vector<Finding> findings = Judged(TwoBalls(), [](const World& world) {
    return Stepped(world, [](WorldState& state) { state.bodies[0].p_WB.y() -= 0.001; });
  });
  const auto found =
      std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
        return finding.measure == MeasureKind::kPenetration;
      });
  ASSERT_NE(found, findings.end());
  EXPECT_EQ(found->verdict, Verdict::kFail);
  EXPECT_THAT(found->proof, HasSubstr("never_penetrates, true of every motion: mine"));
}

// The bodies move by 0.5 m a step and bounce at the end of a step. The law allows 0.75 m
// of depth. A pass allows 4 mm for the ball, 1 % of its diameter, and 2 mm for the plate,
// half of its thickness.
TEST(UniversalLaws, PassNoDepthThatShowsNextToABody) {
  const Shape ball = Sphere{0.2};
  const Shape plate = Box{{0.4, 0.002, 0.4}};
  const auto found = [](double depth, const Shape& shape, double half_height) {
    WorldScenario scenario = TwoBalls();
    scenario.world.bodies.erase(scenario.world.bodies.begin() + 1);
    scenario.world.bodies[0].placed.shape = shape;
    scenario.world.gravity_W.setZero();
    scenario.world.dt = 0.01;
    scenario.world.bodies[0].placed.X_WB.p_WB.y() = 0.5 + half_height - depth;
    scenario.world.bodies[0].v_WB = {0, -50, 0};
    const std::vector<Finding> findings = Judged(scenario, [&](const World& world) {
      return Stepped(world, [&](WorldState& state) {
        BodyState& body = state.bodies[0];
        if (body.p_WB.y() < 0.25) body.v_WB.y() = 50;
        body.p_WB += world.dt * body.v_WB;
      });
    });
    return *std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
      return finding.measure == MeasureKind::kPenetration;
    });
  };
  EXPECT_EQ(found(0.0039, ball, 0.2).verdict, Verdict::kPass);
  EXPECT_EQ(found(0.0041, ball, 0.2).verdict, Verdict::kUndecidable);
  EXPECT_EQ(found(0.0041, ball, 0.2).undecided, Undecided::kCoarse);
  EXPECT_EQ(found(0.0019, plate, 0.002).verdict, Verdict::kPass);
  EXPECT_EQ(found(0.0021, plate, 0.002).verdict, Verdict::kUndecidable);
}

TEST(UniversalLaws, JudgeThePairsThatNoClaimJudges) {
  WorldScenario scenario = TwoBalls();
  scenario.claims = {ClaimOf("never_penetrates", {"near"}, {{"slack", 0.01}})};
  const auto penetration_fails = [&](const Eigen::Vector3d& far) {
    const std::vector<Finding> findings = Judged(scenario, [&](const World& world) {
      return Stepped(world, [&](WorldState& state) { state.bodies[1].p_WB = far; });
    });
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
      return finding.measure == MeasureKind::kPenetration &&
             finding.verdict == Verdict::kFail;
    });
  };
  EXPECT_FALSE(penetration_fails({0.395, 0.2, 0})) << "5 mm in near";
  EXPECT_TRUE(penetration_fails({0.385, 0.2, 0})) << "15 mm in near";
  EXPECT_TRUE(penetration_fails({2, 0.195, 0})) << "5 mm in the ground";
}

TEST(UniversalLaws, FailAMotionThatGainsEnergy) {
  const std::vector<Finding> findings = Judged(TwoBalls(), [](const World& world) {
    return Stepped(world, [](WorldState& state) { state.bodies[1].w_WB.y() += 1; });
  });
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.law == "energy_never_rises" && finding.verdict == Verdict::kFail;
  }));
}

TEST(UniversalLaws, GrantTheWorkOfMovingApartWhatOverlapsAtTheStart) {
  // A ball of 1 kg, 1 cm inside the ground, is lifted by 9.82 N times 1 cm.
  WorldScenario scenario = TwoBalls();
  scenario.world.bodies.erase(scenario.world.bodies.begin() + 1);
  scenario.world.bodies[0].placed.X_WB.p_WB.y() -= 0.01;
  for (const double rises_to : {0.2, 0.215}) {
    const std::vector<Finding> findings = Judged(scenario, [&](const World& world) {
      return Stepped(world,
                     [&](WorldState& state) { state.bodies[0].p_WB.y() = rises_to; });
    });
    const auto energy =
        std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
          return finding.measure == MeasureKind::kEnergyDrift;
        });
    ASSERT_NE(energy, findings.end());
    EXPECT_EQ(energy->verdict != Verdict::kFail, rises_to == 0.2) << energy->proof;
  }
}

TEST(UniversalLaws, SayNothingOfAnEngineWithoutImpulses) {
  for (const Finding& finding : Judged(TwoBalls(), AtRest))
    EXPECT_NE(finding.verdict, Verdict::kUnsupported) << finding.proof;
}

}  // namespace
}  // namespace touchstone
