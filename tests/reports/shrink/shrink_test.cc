#include "reports/shrink/shrink.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"
#include "reports/shrink/reductions.h"
#include "reports/shrink/round_to_digits.h"
#include "reports/shrink/same_fault.h"
#include "reports/shrink/shifts.h"
#include "reports/shrink/shrunk_file.h"
#include "reports/shrink/size.h"
#include "scenarios/scenario_file.h"
#include "tests/reports/fake_oracle.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using Proposal = void (*)(const Question&, const Candidates&);

std::vector<Question> All(Proposal propose, const Question& question) {
  std::vector<Question> candidates;
  propose(question, [&](Question c) { candidates.push_back(std::move(c)); });
  return candidates;
}

/** Whether one of the candidates is valid, smaller and as `wanted` says. */
template <typename Wanted>
bool Offers(Proposal propose, const Question& question, Wanted wanted) {
  const std::vector<Question> all = All(propose, question);
  return std::any_of(all.begin(), all.end(), [&](const Question& candidate) {
    return IsValid(candidate) && SizeOf(candidate) < SizeOf(question) &&
           wanted(candidate);
  });
}

Scenario TwoBoxes() {
  Scenario scenario;
  scenario.id = "mine/boxes";
  scenario.title = "Two boxes";
  scenario.source = "none";
  scenario.name_A = "A";
  scenario.name_B = "B";
  scenario.contact.A = {
      Box{{0.5123, 0.61, 0.7}},
      Pose::FromQuaternion({0.3141, -0.2, 0.7},
                           Eigen::Quaterniond(0.9, 0.1, 0.3, -0.2).normalized())};
  scenario.contact.B = {
      Box{{0.5, 0.4, 0.3}},
      Pose::FromQuaternion({0.9, -0.5, 1.3},
                           Eigen::Quaterniond(0.7, -0.1, 0.2, 0.4).normalized())};
  return scenario;
}

WorldScenario ThreeBalls() {
  WorldScenario scenario;
  scenario.id = "mine/balls";
  scenario.title = "Three balls, two of them on a rod";
  scenario.source = "none";
  for (const char* const name : {"a", "b", "c"}) {
    RigidBody ball;
    ball.name = name;
    ball.placed.shape = Sphere{0.1};
    ball.placed.X_WB = Pose::FromQuaternion(
        {static_cast<double>(scenario.world.bodies.size()), 0, 0}, {1, 0, 0, 0});
    scenario.world.bodies.push_back(ball);
  }
  scenario.world.joints.push_back(
      {.A = {AnchorKind::kBody, 1}, .B = {AnchorKind::kBody, 2}, .length = 1});
  scenario.world.pushes.push_back({.body = 2, .J_W = {0, 1, 0}});
  return scenario;
}

const ContactQuery& ContactOf(const Question& question) {
  return std::get<Scenario>(question).contact;
}

const World& WorldOf(const Question& question) {
  return std::get<WorldScenario>(question).world;
}

TEST(Reductions, LeaveOutABodyWithItsJointsAndKeepTheIndicesOfTheOthers) {
  EXPECT_TRUE(Offers(FewerParts, ThreeBalls(), [](const Question& candidate) {
    const World& world = WorldOf(candidate);
    return world.bodies.size() == 2 && world.bodies[0].name == "b" &&
           world.joints.size() == 1 && world.joints[0].A.index == 0 &&
           world.joints[0].B.index == 1 && world.pushes[0].body == 1;
  }));
  EXPECT_TRUE(Offers(FewerParts, ThreeBalls(), [](const Question& candidate) {
    const World& world = WorldOf(candidate);
    return world.bodies.size() == 2 && world.bodies[1].name == "b" &&
           world.joints.empty() && world.pushes.empty();
  }));
  EXPECT_TRUE(Offers(FewerParts, ThreeBalls(), [](const Question& candidate) {
    return WorldOf(candidate).bodies.size() == 3 && WorldOf(candidate).joints.empty();
  }));
}

TEST(Reductions, EndAWorldAfterOneStepAndAfterOneLess) {
  for (const int steps : {1, 239}) {
    EXPECT_TRUE(Offers(FewerSteps, ThreeBalls(), [&](const Question& candidate) {
      return WorldOf(candidate).steps == steps;
    }));
  }
}

TEST(Reductions, ReplaceABoxByASphereAndAHullByABox) {
  EXPECT_TRUE(Offers(SimplerShapes, TwoBoxes(), [](const Question& candidate) {
    const auto* const sphere = std::get_if<Sphere>(&ContactOf(candidate).A.shape);
    return sphere != nullptr && sphere->radius == 0.5123;
  }));
  Scenario hull = TwoBoxes();
  hull.contact.A.shape = ConvexHull{{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-1, -2, -3}}};
  EXPECT_TRUE(Offers(SimplerShapes, hull, [](const Question& candidate) {
    const auto* const box = std::get_if<Box>(&ContactOf(candidate).A.shape);
    return box != nullptr && box->half_extents == Eigen::Vector3d(1, 2, 3);
  }));
}

TEST(Reductions, LeaveOutHalfOfTheVerticesAndEachOne) {
  Scenario hull = TwoBoxes();
  hull.contact.A.shape = ConvexHull{{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-1, -2, -3}}};
  const auto count_is = [](std::size_t count) {
    return [count](const Question& candidate) {
      return std::get<ConvexHull>(ContactOf(candidate).A.shape).vertices.size() == count;
    };
  };
  EXPECT_TRUE(Offers(FewerVertices, hull, count_is(2)));
  EXPECT_TRUE(Offers(FewerVertices, hull, count_is(3)));
}

TEST(Reductions, PutEachBodyAtTheOriginWithoutMovingThemAgainstEachOther) {
  const Scenario boxes = TwoBoxes();
  EXPECT_TRUE(Offers(CommonFrame, boxes, [&](const Question& candidate) {
    const auto& [A, B] = ContactOf(candidate);
    // A point of B, seen from A, is where it was, to a few roundings.
    const Eigen::Vector3d x(0.1, 0.2, 0.3);
    const Pose& X_WA = boxes.contact.A.X_WB;
    const Eigen::Vector3d before =
        X_WA.R_WB.transpose() * (boxes.contact.B.X_WB * x - X_WA.p_WB);
    return A.X_WB.p_WB.isZero(0) && A.X_WB.R_WB.isIdentity(0) &&
           (B.X_WB * x - before).norm() < 16 * 0x1p-53;
  }));
}

TEST(Reductions, ReplaceARotationByTheIdentityAndByFewDigitsNearby) {
  const Scenario boxes = TwoBoxes();
  EXPECT_TRUE(Offers(PlainRotations, boxes, [](const Question& candidate) {
    return ContactOf(candidate).A.X_WB.R_WB.isIdentity(0);
  }));
  EXPECT_TRUE(Offers(PlainRotations, boxes, [&](const Question& candidate) {
    const Pose& X = ContactOf(candidate).B.X_WB;
    if (!X.q_WB) return false;
    const Eigen::Vector4d hundredths = 100 * X.q_WB->coeffs();
    // Each of four integers is off by at most 2.5 hundredths, so q by 0.05; a rotation is
    // off by 2 sqrt(2) times as much (Frobenius norm).
    return (hundredths - hundredths.array().round().matrix()).norm() < 1e-12 &&
           (X.R_WB - boxes.contact.B.X_WB.R_WB).norm() < 2 * std::sqrt(2) * 0.05;
  }));
}

// "-0.0" in a file is one more thing that a reader wonders about.
TEST(Reductions, RoundNoRotationToMinusZero) {
  Scenario boxes = TwoBoxes();
  boxes.contact.B.X_WB =
      Pose::FromQuaternion({0.9, -0.5, 1.3}, {-0.004, 1, 0.002, -0.003});
  EXPECT_FALSE(Offers(PlainRotations, boxes, [](const Question& candidate) {
    const Pose& X = ContactOf(candidate).B.X_WB;
    if (!X.q_WB) return false;
    const Eigen::Vector4d& q = X.q_WB->coeffs();
    return std::any_of(q.begin(), q.end(),
                       [](double x) { return x == 0 && std::signbit(x); });
  }));
}

TEST(Reductions, MakeSizesEqual) {
  EXPECT_TRUE(Offers(EqualSizes, TwoBoxes(), [](const Question& candidate) {
    return std::get<Box>(ContactOf(candidate).B.shape).half_extents ==
           Eigen::Vector3d(0.5, 0.5, 0.5);
  }));
}

TEST(Reductions, ScaleByPowersOfTen) {
  Scenario tiny = TwoBoxes();
  for (Body* const body : {&tiny.contact.A, &tiny.contact.B}) {
    body->shape = Sphere{3e-7};
    body->X_WB.p_WB = {2e-7, 0, 0};
  }
  EXPECT_TRUE(Offers(UnitScale, tiny, [](const Question& candidate) {
    return std::get<Sphere>(ContactOf(candidate).A.shape).radius == 3 &&
           ContactOf(candidate).B.X_WB.p_WB == Eigen::Vector3d(2, 0, 0);
  }));
}

TEST(Reductions, ShortenOneNumberAndAllAtOnce) {
  for (const double shorter : {0.0, 1.0, 0.3, 0.31, 0.314}) {
    EXPECT_TRUE(Offers(ShortNumbers, TwoBoxes(), [&](const Question& candidate) {
      const auto& [A, B] = ContactOf(candidate);
      return A.X_WB.p_WB[0] == shorter &&
             std::get<Box>(A.shape).half_extents[0] == 0.5123;
    }));
  }
  EXPECT_TRUE(Offers(ShortNumbers, TwoBoxes(), [](const Question& candidate) {
    const auto& [A, B] = ContactOf(candidate);
    return A.X_WB.p_WB[0] == 0.31 && std::get<Box>(A.shape).half_extents[0] == 0.51;
  }));
}

TEST(Size, GrowsWithTheDecadesOfANumberBeyondATenthAndTen) {
  const auto decades = [](double size) {
    Scenario scenario = TwoBoxes();
    std::get<Box>(scenario.contact.A.shape).half_extents[0] = size;
    return SizeOf(scenario).decades;
  };
  for (const double ordinary : {0.1, 0.5, 1.0, 9.99}) EXPECT_EQ(decades(ordinary), 0);
  EXPECT_EQ(decades(10), 1);
  EXPECT_EQ(decades(2500), 3);
  EXPECT_EQ(decades(0.0999), 1);
  EXPECT_EQ(decades(3e-7), 6);
  Scenario large = TwoBoxes();
  std::get<Box>(large.contact.A.shape).half_extents[0] = 1000;
  EXPECT_GT(SizeOf(large), SizeOf(TwoBoxes())) << "though it has fewer digits";
}

TEST(RoundToDigits, RoundsToDecimals) {
  EXPECT_EQ(RoundToDigits(0.3149, 3), 0.315);
  EXPECT_EQ(RoundToDigits(-1234.5, 2), -1200);
  EXPECT_EQ(RoundToDigits(0, 4), 0);
}

/** A direction that is 0.1 m longer than the shortest, where 1 mm is allowed. */
Finding LongDirection() {
  Finding finding;
  finding.measure = MeasureKind::kExcess;
  finding.value = 0.1;
  finding.tolerance = 1e-3;
  finding.verdict = Verdict::kFail;
  finding.grade = Grade::kLarge;
  return finding;
}

TEST(SameFault, DoesNotShrinkIntoARounding) {
  const Finding original = LongDirection();
  EXPECT_TRUE(IsSameFault(original, original));
  Finding other = original;
  other.value = 0.049;
  EXPECT_FALSE(IsSameFault(other, original));  // Less than half of the excess.
  other = original;
  other.grade = Grade::kSmall;
  EXPECT_FALSE(IsSameFault(other, original));
  other = original;
  other.verdict = Verdict::kInvalid;
  EXPECT_FALSE(IsSameFault(other, original));
}

TEST(SameFault, StaysOverTheNumberThatTheUserGives) {
  const Finding original = LongDirection();
  Finding other = original;
  other.value = 0.02;
  other.grade = Grade::kSmall;
  EXPECT_TRUE(IsSameFault(other, original, 0.01));
  EXPECT_FALSE(IsSameFault(other, original, 0.02));
  other.law = "another";
  EXPECT_FALSE(IsSameFault(other, original, 0.01));
}

/** The fault that AskAlone() finds first. */
Finding FirstFault(const Question& question, const Oracle& oracle) {
  for (const Finding& finding : AskAlone(question, oracle).findings) {
    if (IsFailure(finding.verdict)) return finding;
  }
  ADD_FAILURE() << "no fault";
  return {};
}

TEST(Shrink, EndsAtUnitShapesIfTheFaultIsEverywhere) {
  const FakeOracle oracle =
      FakeOracle::Wrong("wrong", [](const ContactQuery&, ContactAnswer& answer) {
        answer.touching = !answer.touching;
      });
  const Question question = TwoBoxes();
  const Shrunk shrunk = Shrink(question, oracle, FirstFault(question, oracle));
  EXPECT_TRUE(shrunk.is_smallest);
  EXPECT_LT(SizeOf(shrunk.question), SizeOf(question));
  const auto& [A, B] = ContactOf(shrunk.question);
  EXPECT_EQ(KindOf(A.shape), ShapeKind::kSphere);
  EXPECT_EQ(KindOf(B.shape), ShapeKind::kSphere);
  EXPECT_TRUE(A.X_WB.R_WB.isIdentity(0));
  EXPECT_TRUE(B.X_WB.R_WB.isIdentity(0));
}

TEST(Shrink, StopsAfterTheTriesItIsGiven) {
  const FakeOracle oracle =
      FakeOracle::Wrong("wrong", [](const ContactQuery&, ContactAnswer& answer) {
        answer.touching = !answer.touching;
      });
  const Question question = TwoBoxes();
  const Shrunk shrunk =
      Shrink(question, oracle, FirstFault(question, oracle), {.tries = 3});
  EXPECT_EQ(shrunk.tried, 3u);
  EXPECT_FALSE(shrunk.is_smallest);
}

TEST(Shrink, EndsWithWhatItHasIfItIsStopped) {
  const FakeOracle oracle =
      FakeOracle::Wrong("wrong", [](const ContactQuery&, ContactAnswer& answer) {
        answer.touching = !answer.touching;
      });
  const Question question = TwoBoxes();
  std::size_t asked = 0;
  const Shrunk shrunk = Shrink(
      question, oracle, FirstFault(question, oracle),
      {.on_try = [&](std::size_t n) { asked = n; }, .stop = [&] { return asked >= 2; }});
  EXPECT_EQ(shrunk.tried, 2u);
  EXPECT_GT(shrunk.accepted, 0u);
  EXPECT_LT(SizeOf(shrunk.question), SizeOf(question));
  EXPECT_FALSE(shrunk.is_smallest);
}

TEST(Shifts, MoveBByAHundredthOfTheSmallestFeature) {
  const Scenario boxes = TwoBoxes();
  const std::vector<Scenario> shifts = ShiftsOf(boxes);
  ASSERT_EQ(shifts.size(), kShifts);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Scenario& shifted : shifts) {
    EXPECT_TRUE(IsValid(shifted));
    const Pose& pose = shifted.contact.B.X_WB;
    const Eigen::Vector3d moved = pose.p_WB - boxes.contact.B.X_WB.p_WB;
    EXPECT_NEAR(moved.norm(), 0.01 * 0.3, 1e-15);
    EXPECT_GT((pose.R_WB - boxes.contact.B.X_WB.R_WB).norm(), 1e-3);
    sum += moved;
  }
  EXPECT_LT(sum.norm(), 1e-15);  // In all directions alike.
}

/** Two balls, B at (0.87654, 0, 0). */
Question TwoBalls() {
  Scenario balls = TwoBoxes();
  balls.contact.A = {Sphere{0.5}, {}};
  balls.contact.B = {Sphere{0.5}, Pose::FromQuaternion({0.87654, 0, 0}, {1, 0, 0, 0})};
  return balls;
}

// A second fault, at distances of one digit, looks like the first one and has shorter
// numbers.
TEST(Shrink, DoesNotSlipToAFaultOfExactNumbers) {
  const FakeOracle oracle =
      FakeOracle::Wrong("wrong", [](const ContactQuery& query, ContactAnswer& answer) {
        const double distance = (query.B.X_WB.p_WB - query.A.X_WB.p_WB).norm();
        const bool is_of_one_digit = std::remainder(distance, 0.1) == 0;
        if (is_of_one_digit || (distance > 0.82 && distance < 0.89))
          *answer.separation -= 0.2;
      });
  const Question question = TwoBalls();
  const Shrunk shrunk = Shrink(question, oracle, FirstFault(question, oracle));
  EXPECT_GT(shrunk.accepted, 0u);
  EXPECT_GE(shrunk.shifts.value(), kShifts / 2);
  const auto& [A, B] = ContactOf(shrunk.question);
  const double distance = (B.X_WB.p_WB - A.X_WB.p_WB).norm();
  EXPECT_GT(distance, 0.82);
  EXPECT_LT(distance, 0.89);
}

TEST(Shrink, KeepsAFaultOfAnExactTie) {
  const FakeOracle oracle =
      FakeOracle::Wrong("wrong", [](const ContactQuery& query, ContactAnswer& answer) {
        if (query.B.X_WB.p_WB.y() == 0) *answer.separation -= 0.2;
      });
  const Question question = TwoBalls();
  const Shrunk shrunk = Shrink(question, oracle, FirstFault(question, oracle));
  EXPECT_GT(shrunk.accepted, 0u);
  EXPECT_LT(shrunk.shifts.value(), kShifts);
  EXPECT_TRUE(shrunk.is_smallest);
}

/** A fault of an engine that the ledger knows. */
struct KnownFault {
  const char* scenario;
  const char* oracle;
};

class ShrinkOfAKnownFault : public testing::TestWithParam<KnownFault> {};

TEST_P(ShrinkOfAKnownFault, IsSmallerIsRepeatableAndIsFoundAgainInItsFile) {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  const Oracle* const oracle = registry.Find(GetParam().oracle);
  if (oracle == nullptr) GTEST_SKIP() << GetParam().oracle << " is not in this build";
  const ReadResult read = ReadScenarioFile(InSourceTree("scenarios/catalogue") /
                                           (std::string(GetParam().scenario) + ".toml"));
  const Question question =
      read.world ? Question(*read.world) : Question(read.scenario.value());
  const Finding fault = FirstFault(question, *oracle);
  const ShrinkOptions options{.tries = 400};
  const Shrunk shrunk = Shrink(question, *oracle, fault, options);
  EXPECT_GT(shrunk.accepted, 0u);
  EXPECT_LT(SizeOf(shrunk.question), SizeOf(question));

  const std::string file = FileOf(shrunk, question);
  EXPECT_EQ(FileOf(Shrink(question, *oracle, fault, options), question), file);

  const ReadResult again = ReadScenario(file, "shrunk.toml");
  ASSERT_TRUE(again.diagnostics.empty()) << ToString(again.diagnostics.front());
  const RunReport report = AskAlone(
      again.world ? Question(*again.world) : Question(again.scenario.value()), *oracle);
  EXPECT_TRUE(
      std::any_of(report.findings.begin(), report.findings.end(),
                  [&](const Finding& finding) { return IsSameFault(finding, fault); }));
  EXPECT_THAT(report.faults, testing::IsEmpty());  // The indictment is confirmed.
}

INSTANTIATE_TEST_SUITE_P(
    Catalogue, ShrinkOfAKnownFault,
    testing::Values(KnownFault{"contact/zoo/fcl_508y", "fcl/distance"},
                    KnownFault{"contact/box_box/edge_edge_deep", "libccd/mpr"},
                    KnownFault{"contact/zoo/fcl_395", "ode"},
                    KnownFault{"contact/zoo/fcl_395", "dart"},
                    KnownFault{"world/friction/wedge_at_25_degrees", "bullet"}),
    [](const testing::TestParamInfo<KnownFault>& instance) {
      std::string name =
          fmt::format("{}_of_{}", instance.param.scenario, instance.param.oracle);
      std::replace(name.begin(), name.end(), '/', '_');
      return name;
    });

}  // namespace
}  // namespace touchstone
