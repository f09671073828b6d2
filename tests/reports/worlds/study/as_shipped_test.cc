#include "reports/worlds/study/as_shipped.h"

#include <atomic>
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
  std::vector<Finding> findings = ExamineWorld(scenario, oracle).findings;
  CompareWithShipped(scenario, oracle, findings);
  for (const Finding& finding : findings)
    if (finding.measure == MeasureKind::kPositionError) return finding;
  ADD_FAILURE() << "no place was judged";
  return {};
}

TEST(CompareWithShipped, AsksAWorldWithoutFailuresOnlyOnce) {
  const DriftingOracle oracle({0, 1}, {1, 1});
  const WorldScenario scenario = TwoBallsInFlight();
  std::vector<Finding> findings = ExamineWorld(scenario, oracle).findings;
  const int begun = oracle.begun;
  CompareWithShipped(scenario, oracle, findings);
  EXPECT_EQ(oracle.begun, begun);
  EXPECT_EQ(PlaceOf(oracle).shipped, Shipped::kNotAsked);
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

TEST(CompareWithShipped, NamesAllSettingsIfNoneDecidesAlone) {
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
              HasSubstr("no default alone is enough, of first = 0, 1 here; second = 0"));
}

// A variant costs as many motions as it has worlds; a law needs one.
TEST(CompareWithShipped, AsksForVariantsAgainOnlyWhereASettingMayDecideThem) {
  const DriftingOracle oracle({1, 0}, {1, 2});
  const WorldScenario scenario = TwoBallsInFlight();
  std::vector<Finding> findings = ExamineWorld(scenario, oracle).findings;
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
  CompareWithShipped(scenario, oracle, findings);
  // Once as shipped with all variants, and one motion for either setting.
  EXPECT_EQ(oracle.begun, 2 * of_study + 2);
}

// The motion itself, half the step, two moved starts and the variant.
TEST(CompareWithShipped, AsksForNoOtherVariantThanTheOneThatASettingMayDecide) {
  const DriftingOracle oracle({1, 0}, {1, 1});
  const WorldScenario scenario = TwoBallsInFlight();
  std::vector<Finding> findings = ExamineWorld(scenario, oracle).findings;
  const int of_study = oracle.begun;
  std::erase_if(findings, [](const Finding& finding) {
    return finding.measure != MeasureKind::kHeading;
  });
  ASSERT_THAT(findings, testing::SizeIs(1));
  ASSERT_EQ(findings.front().verdict, Verdict::kFail);
  CompareWithShipped(scenario, oracle, findings);
  EXPECT_EQ(findings.front().shipped, Shipped::kHereOnly);
  EXPECT_THAT(findings.front().shipped_because,
              HasSubstr("the default first = 0, 1 here, is enough"));
  // All as shipped, and these five with the default of the only other setting.
  EXPECT_EQ(oracle.begun, 2 * of_study + 5);
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
  std::vector<Finding> findings = ExamineWorld(scenario, oracle).findings;
  CompareWithShipped(scenario, oracle, findings);
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

TEST(CompareWithShipped, MarksAPassThatFailsAsShippedIfAnotherFaultHasItAskedAgain) {
  const DriftingOracle oracle({0, 1}, {1, 1});
  const WorldScenario scenario = TwoBallsInFlight();
  std::vector<Finding> findings = ExamineWorld(scenario, oracle).findings;
  Finding planted;
  planted.scenario = scenario.id;
  planted.oracle = "drifting";
  planted.reference = "law";
  planted.law = "another";
  planted.measure = MeasureKind::kEnergyDrift;
  planted.verdict = Verdict::kFail;
  findings.push_back(planted);
  CompareWithShipped(scenario, oracle, findings);
  int marked = 0;
  for (const Finding& finding : findings) {
    if (finding.shipped == Shipped::kNotAsked) continue;
    ++marked;
    EXPECT_EQ(finding.shipped, Shipped::kShippedOnly) << NameOf(finding.measure);
    EXPECT_EQ(finding.verdict, Verdict::kPass);
  }
  EXPECT_GE(marked, 1);
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
  std::vector<Finding> findings = ExamineWorld(scenario, oracle).findings;
  CompareWithShipped(scenario, oracle, findings);
  std::vector<Shipped> places;
  for (const Finding& finding : findings)
    if (finding.measure == MeasureKind::kPositionError) places.push_back(finding.shipped);
  EXPECT_THAT(places, testing::ElementsAre(Shipped::kNotAsked, Shipped::kBoth));
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
