#include "reports/worlds/study/as_shipped.h"

#include <atomic>
#include <limits>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/examine_world.h"
#include "tests/reports/worlds/fake_simulator.h"
#include "tests/reports/worlds/motions.h"
#include "tests/reports/worlds/study/studied.h"
#include "tests/reports/worlds/study/tie.h"

namespace touchstone {
namespace {

using testing::HasSubstr;

// Two balls in exact flight, to which a parameter may add a constant drift.
class Drifting final : public Simulation {
 public:
  /** The bodies before `first` do not drift. */
  Drifting(const World& world, double drift, std::size_t first = 0)
      : world_(world), drift_(drift), first_(first) {}
  void Push(int, const Eigen::Vector3d&, const Eigen::Vector3d&) override {}
  void Step() override { ++step_; }
  void Read(WorldState& state) const override {
    const double t = step_ * world_.dt;
    state.bodies.clear();
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      const RigidBody& body = world_.bodies[i];
      state.bodies.push_back(
          {body.placed.X_WB.p_WB + t * body.v_WB + 0.5 * t * t * world_.gravity_W +
               Eigen::Vector3d(i < first_ ? 0 : drift_ * t, 0, 0),
           Turned(Eigen::Quaterniond(body.placed.X_WB.R_WB), t * body.w_WB),
           body.v_WB + t * world_.gravity_W, body.w_WB});
    }
  }

 private:
  World world_;
  double drift_;
  std::size_t first_;
  int step_ = 0;
};

// An engine that drifts by the product of its two parameters. [m/s]
class DriftingOracle final : public Oracle {
 public:
  struct Values {
    double here;
    double shipped;
  };
  DriftingOracle(Values first, Values second) {
    info_.name = "drifting";
    info_.simulates = true;
    info_.world_capabilities.fill({true, ""});
    const auto add = [&](const char* name, Values values) {
      info_.parameters.push_back({.name = name,
                                  .here = values.here,
                                  .shipped = values.shipped,
                                  .least = 0,
                                  .most = 10,
                                  .whole = false,
                                  .what = "drift",
                                  .why = ""});
    };
    add("first", first);
    add("second", second);
  }
  const OracleInfo& info() const override { return info_; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}
  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    ++begun;
    return std::make_unique<Drifting>(world, values[0] * values[1]);
  }
  mutable std::atomic<int> begun = 0;

 private:
  OracleInfo info_;
};

/** Returns the finding of the flight's places. */
Finding PlaceOf(const Oracle& oracle) {
  const WorldScenario scenario = TwoBallsInFlight();
  Examination examined = ExamineWorld(scenario, oracle);
  std::vector<Finding>& findings = examined.findings;
  CompareWithShipped(scenario, oracle, examined.trajectory, findings);
  for (const Finding& finding : findings)
    if (finding.measure == MeasureKind::kPositionError) return finding;
  ADD_FAILURE() << "no place was judged";
  return {};
}

TEST(CompareWithShipped, AsksAWorldWithoutFailuresOnceIfNothingDiffers) {
  const DriftingOracle oracle({0, 0}, {1, 2});
  const WorldScenario scenario = TwoBallsInFlight();
  Examination examined = ExamineWorld(scenario, oracle);
  const int begun = oracle.begun;
  CompareWithShipped(scenario, oracle, examined.trajectory, examined.findings);
  EXPECT_EQ(oracle.begun, begun + 1);
  for (const Finding& finding : examined.findings)
    EXPECT_EQ(finding.shipped, Shipped::kNotAsked) << NameOf(finding.measure);
}

TEST(CompareWithShipped, DoesNotAskALargeWorldWithoutFailures) {
  const DriftingOracle oracle({0, 1}, {1, 1});
  WorldScenario scenario = TwoBallsInFlight();
  scenario.world.dt /= 1e5;
  scenario.world.steps *= 100'000;
  std::vector<Finding> findings(1);
  Trajectory motion;
  motion.status = AnswerStatus::kAnswered;
  CompareWithShipped(scenario, oracle, motion, findings);
  EXPECT_EQ(oracle.begun, 0);
}

TEST(CompareWithShipped, NamesTheSettingWhoseDefaultFailsAPass) {
  const Finding place = PlaceOf(DriftingOracle({0, 1}, {1, 2}));
  EXPECT_EQ(place.verdict, Verdict::kPass);
  EXPECT_EQ(place.shipped, Shipped::kShippedOnly);
  EXPECT_THAT(place.shipped_because,
              HasSubstr("as shipped; the default first = 1, 0 here, is enough"));
}

// 0 × 0 m/s here: only both defaults together drift.
TEST(CompareWithShipped, NamesTheSettingsWhoseDefaultsFailAPassTogether) {
  const Finding place = PlaceOf(DriftingOracle({0, 1}, {0, 1}));
  EXPECT_EQ(place.shipped, Shipped::kShippedOnly);
  EXPECT_THAT(place.shipped_because,
              HasSubstr("no default alone is enough, but together first = 1, 0 here; "
                        "second = 1, 0 here"));
}

TEST(CompareWithShipped, SaysThatAFaultShowsBothWays) {
  const Finding place = PlaceOf(DriftingOracle({1, 2}, {1, 1}));
  EXPECT_EQ(place.verdict, Verdict::kFail);
  EXPECT_EQ(place.shipped, Shipped::kBoth);
  EXPECT_THAT(place.shipped_because, HasSubstr("is allowed as shipped"));
}

TEST(CompareWithShipped, NamesTheSettingWhoseDefaultLetsAFaultPass) {
  const Finding place = PlaceOf(DriftingOracle({1, 0}, {1, 2}));
  EXPECT_EQ(place.verdict, Verdict::kFail);
  EXPECT_EQ(place.shipped, Shipped::kHereOnly);
  EXPECT_THAT(place.shipped_because,
              HasSubstr("the default first = 0, 1 here, is enough"));
}

TEST(CompareWithShipped, NamesTheSettingsThatDecideTogether) {
  // 1 × 1 m/s here and as shipped only nothing, but either default alone drifts.
  class Sum final : public Oracle {
   public:
    Sum() : info_(DriftingOracle({1, 0}, {1, 0}).info()) {}
    const OracleInfo& info() const override { return info_; }
    using Oracle::Answer;
    void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}
    std::unique_ptr<Simulation> BeginWith(const World& world,
                                          std::span<const double> values) const override {
      return std::make_unique<Drifting>(world, values[0] + values[1]);
    }

   private:
    OracleInfo info_;
  };
  const Finding place = PlaceOf(Sum());
  EXPECT_EQ(place.shipped, Shipped::kHereOnly);
  EXPECT_THAT(place.shipped_because,
              HasSubstr("no default alone is enough, but together first = 0, 1 here; "
                        "second = 0"));
}

// A variant costs as many motions as it has worlds; a law needs one.
TEST(CompareWithShipped, AsksForVariantsAgainOnlyWhereASettingMayDecideThem) {
  const DriftingOracle oracle({1, 0}, {1, 2});
  const WorldScenario scenario = TwoBallsInFlight();
  Examination examined = ExamineWorld(scenario, oracle);
  std::vector<Finding>& findings = examined.findings;
  const int of_study = oracle.begun;
  ASSERT_GT(of_study, 5);
  // The default restores the limit of smaller steps and the heading, too, and either
  // needs several motions.
  std::erase_if(findings, [](const Finding& finding) {
    return finding.reference != "law" || finding.measure == MeasureKind::kLimitError ||
           finding.measure == MeasureKind::kObservedOrder;
  });
  // A variant that fails here and has no counterpart as shipped.
  Finding planted;
  planted.scenario = scenario.id;
  planted.oracle = "drifting";
  planted.law = "another";
  planted.measure = MeasureKind::kMirror;
  planted.verdict = Verdict::kFail;
  findings.push_back(planted);
  CompareWithShipped(scenario, oracle, examined.trajectory, findings);
  // As shipped the motion itself, half the step, two moved starts and the variant, as it
  // differs; and one motion for either setting.
  EXPECT_EQ(oracle.begun, of_study + 5 + 2);
}

// The motion itself, half the step, two moved starts and the variant.
TEST(CompareWithShipped, AsksForNoOtherVariantThanTheOneThatASettingMayDecide) {
  const DriftingOracle oracle({1, 0}, {1, 1});
  const WorldScenario scenario = TwoBallsInFlight();
  Examination examined = ExamineWorld(scenario, oracle);
  std::vector<Finding>& findings = examined.findings;
  const int of_study = oracle.begun;
  std::erase_if(findings, [](const Finding& finding) {
    return finding.measure != MeasureKind::kHeading;
  });
  ASSERT_THAT(findings, testing::SizeIs(1));
  ASSERT_EQ(findings.front().verdict, Verdict::kFail);
  CompareWithShipped(scenario, oracle, examined.trajectory, findings);
  EXPECT_EQ(findings.front().shipped, Shipped::kHereOnly);
  EXPECT_THAT(findings.front().shipped_because,
              HasSubstr("the default first = 0, 1 here, is enough"));
  // As shipped, and with the default of the only other setting.
  EXPECT_EQ(oracle.begun, of_study + 5 + 5);
}

// As set here a ball drifts by its place in the world, so that every variant fails. As
// shipped a rounding decides when it turns back.
TEST(CompareWithShipped, SaysNothingOfAFaultThatCannotBeComparedAsShipped) {
  class Drifts final : public FakeSimulator {
   public:
    Drifts()
        : FakeSimulator("engine", [](const World& world) {
            return Stepped(world, [&](WorldState& state) {
              BodyState& ball = state.bodies[BallOf(world)];
              ball.p_WB += world.dt * (ball.v_WB + Eigen::Vector3d(ball.p_WB.x(), 0, 0));
            });
          }) {
      info_ = FakeSimulator::info();
      info_.parameters = DriftingOracle({1, 0}, {1, 1}).info().parameters;
    }
    const OracleInfo& info() const override { return info_; }
    std::unique_ptr<Oracle> SetUp(const WorldSetup&) const override {
      return std::make_unique<FakeSimulator>("engine", TurnsBackNear);
    }

   private:
    OracleInfo info_;
  };
  const WorldScenario scenario = Tie();
  const Drifts oracle;
  const std::vector<Finding> shipped =
      ExamineWorld(scenario, *oracle.SetUp({.as_shipped = true, .chosen = {}})).findings;
  Examination examined = ExamineWorld(scenario, oracle);
  std::vector<Finding>& findings = examined.findings;
  CompareWithShipped(scenario, oracle, examined.trajectory, findings);
  int not_compared = 0;
  for (const Finding& finding : findings) {
    if (finding.verdict != Verdict::kFail) continue;
    for (const Finding& other : shipped) {
      if (other.measure != finding.measure || other.law != finding.law ||
          other.verdict != Verdict::kUnsupported)
        continue;
      ++not_compared;
      EXPECT_EQ(finding.shipped, Shipped::kNotAsked) << NameOf(finding.measure);
    }
  }
  EXPECT_GT(not_compared, 0);
}

TEST(CompareWithShipped, ComparesEachOfSeveralClaimsOfOneLawWithItself) {
  // The far ball drifts either way, the near one never.
  class FarDrifts final : public Oracle {
   public:
    FarDrifts() : info_(DriftingOracle({1, 1}, {2, 1}).info()) {}
    const OracleInfo& info() const override { return info_; }
    using Oracle::Answer;
    void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}
    std::unique_ptr<Simulation> BeginWith(const World& world,
                                          std::span<const double> values) const override {
      return std::make_unique<Drifting>(world, values[0], 1);
    }

   private:
    OracleInfo info_;
  };
  const FarDrifts oracle;
  WorldScenario scenario = TwoBallsInFlight();
  scenario.claims = {ClaimOf("ballistic", {"near"}), ClaimOf("ballistic", {"far"})};
  Examination examined = ExamineWorld(scenario, oracle);
  std::vector<Finding>& findings = examined.findings;
  CompareWithShipped(scenario, oracle, examined.trajectory, findings);
  std::vector<Shipped> places;
  for (const Finding& finding : findings)
    if (finding.measure == MeasureKind::kPositionError) places.push_back(finding.shipped);
  EXPECT_THAT(places, testing::ElementsAre(Shipped::kNotAsked, Shipped::kBoth));
}

TEST(CompareWithShipped, SaysThatAnAnswerIsMissingOnlyAsShipped) {
  class Silent final : public Oracle {
   public:
    Silent() : info_(DriftingOracle({0, 1}, {1, 1}).info()) {}
    const OracleInfo& info() const override { return info_; }
    using Oracle::Answer;
    void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}
    std::unique_ptr<Simulation> BeginWith(const World& world,
                                          std::span<const double> values) const override {
      return std::make_unique<Drifting>(
          world, values[0] == 0 ? 0 : std::numeric_limits<double>::quiet_NaN());
    }

   private:
    OracleInfo info_;
  };
  const Silent oracle;
  const WorldScenario scenario = TwoBallsInFlight();
  Examination examined = ExamineWorld(scenario, oracle);
  CompareWithShipped(scenario, oracle, examined.trajectory, examined.findings);
  const Finding& answering = examined.findings.front();
  EXPECT_EQ(answering.verdict, Verdict::kPass);
  EXPECT_EQ(answering.shipped, Shipped::kShippedOnly);
  EXPECT_THAT(answering.shipped_because,
              testing::AllOf(HasSubstr("as shipped it gives no motion"),
                             HasSubstr("the default first = 1, 0 here, is enough")));
}

TEST(CompareWithShipped, AsksNobodyTwiceWhoIsSetUpAsShipped) {
  const DriftingOracle oracle({0, 1}, {1, 1});
  const auto shipped = oracle.SetUp({.as_shipped = true, .chosen = {}});
  const Finding place = PlaceOf(*shipped);
  EXPECT_EQ(place.verdict, Verdict::kFail);
  EXPECT_EQ(place.shipped, Shipped::kNotAsked);
}

}  // namespace
}  // namespace touchstone
