#include "reports/clusters/clusters.h"

#include <cmath>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/clusters/measure_words.h"
#include "reports/clusters/ordinary.h"
#include "reports/finding/grade.h"
#include "reports/text/si_quantity.h"

namespace touchstone {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/** Two unit cubes, B at `x` along the x axis. */
ContactQuery Cubes(double x, double half = 0.5) {
  ContactQuery query;
  query.A = {Box{{half, half, half}}, {}};
  query.B = {Box{{half, half, half}}, {}};
  query.B.X_WB.p_WB.x() = x;
  return query;
}

ScenarioResult Question(const std::string& id, double x) {
  ScenarioResult result;
  result.scenario.id = id;
  result.scenario.contact = Cubes(x);
  result.truth.touching = x < 1 ? Touching::kTouching : Touching::kApart;
  result.truth.separation = {x - 1, x - 1};
  return result;
}

Finding Fault(const std::string& scenario, const std::string& oracle, double value) {
  Finding finding;
  finding.scenario = scenario;
  finding.oracle = oracle;
  finding.reference = "referee";
  finding.measure = MeasureKind::kSeparationError;
  finding.value = value;
  finding.verdict = Verdict::kFail;
  finding.cause = Cause::kDefect;
  finding.grade = GradeOfShare(value / std::sqrt(3.0));
  return finding;
}

/** Three questions to two engines. */
RunReport Report() {
  RunReport report;
  report.oracles.resize(2);
  report.oracles[0].name = "ode";
  report.oracles[0].library = "ODE";
  report.oracles[1].name = "bullet";
  report.oracles[1].library = "Bullet";
  report.subject = "ode";
  report.scenarios = {Question("a", 0.9), Question("b", 0.9), Question("c", 1 + 1e-9)};
  LedgerEntry faces;
  faces.fault = "dBoxBox prefers a face by 5 %.";
  faces.reason = "A face is preferred: depths are too large.";
  faces.upstream = "unreported";
  LedgerEntry edges = faces;
  edges.fault.clear();
  edges.reason = "dBoxBox prefers a face by 5 %. And edges are lost.";
  report.ledger.entries = {faces, edges};
  return report;
}

Finding Known(Finding finding, int entry) {
  finding.verdict = Verdict::kKnown;
  finding.ledger_entry = entry;
  return finding;
}

TEST(ClustersOf, GroupsKnownFaultsByTheFaultOfTheirEntries) {
  RunReport report = Report();
  report.findings = {Known(Fault("a", "ode", 0.01), 0),
                     Known(Fault("a", "bullet", 0.02), 1),
                     Known(Fault("b", "ode", 0.03), 0)};
  const Clusters clusters = ClustersOf(report);
  ASSERT_EQ(clusters.ranked.size(), 1U);
  const Cluster& cluster = clusters.ranked[0];
  EXPECT_EQ(ExtentOf(report, cluster),
            "ODE and Bullet, in 2 scenarios, at worst 3 cm, 1.7 % of the smaller body.");
  EXPECT_EQ(cluster.title, "dBoxBox prefers a face by 5 %.");
  EXPECT_THAT(cluster.oracles, ElementsAre(0, 1));
  EXPECT_THAT(cluster.questions, ElementsAre(1, 0));  // The larger error first.
  EXPECT_EQ(cluster.worst, 2U);
  EXPECT_EQ(cluster.grade, Grade::kLarge);
  EXPECT_FALSE(cluster.is_new);
  EXPECT_EQ(cluster.upstream, "unreported");
  EXPECT_NEAR(cluster.share, 0.03 / std::sqrt(3.0), 1e-12);
  EXPECT_THAT(clusters.of_finding, ElementsAre(0, 0, 0));
}

// It has the name and the reason that the ledger gives it, and is no new fault; yet it is
// not excused either.
TEST(ClustersOf, TellsAKnownFaultThatHasOutgrownItsBound) {
  RunReport report = Report();
  Finding outgrown = Fault("b", "ode", 0.3);
  outgrown.outgrown_entry = 0;
  report.findings = {Known(Fault("a", "ode", 0.01), 0), outgrown};
  const Clusters clusters = ClustersOf(report);
  ASSERT_EQ(clusters.ranked.size(), 2U);
  const Cluster& larger = clusters.ranked[0];
  EXPECT_EQ(larger.title, "dBoxBox prefers a face by 5 %.");
  EXPECT_EQ(larger.reason, "A face is preferred: depths are too large.");
  EXPECT_TRUE(larger.has_outgrown);
  EXPECT_FALSE(larger.is_new);
  EXPECT_EQ(clusters.ranked[1].title, larger.title);
  EXPECT_FALSE(clusters.ranked[1].has_outgrown);
}

// 2.5 m = 3 cm + 3.07 rad · 0.8 m, and no point has moved that far.
TEST(ClustersOf, LeadsWithTheAngleWhereMostOfAnErrorIsOne) {
  RunReport report = Report();
  Finding turned = Fault("a", "ode", 2.5);
  turned.measure = MeasureKind::kHeading;
  Proof places;
  places.kind = ProofKind::kPlaces;
  places.points_W = {{0, 0, 1}, {0.03, 0, 1}};
  places.rest = 3.07;
  turned.evidence = std::make_shared<const Proof>(places);
  report.findings = {turned};
  const Clusters clusters = ClustersOf(report);
  EXPECT_EQ(ExtentOf(report, clusters.ranked[0]),
            "In 1 scenario, at worst 176° and 3 cm.");
  places.points_W[1].x() = 2;
  report.findings[0].evidence = std::make_shared<const Proof>(places);
  EXPECT_EQ(ExtentOf(report, clusters.ranked[0]),
            "In 1 scenario, at worst 2.5 m, 1.4 times the smaller body.");
}

// A missed hit 10 µm deep is a wrong answer; that another depth is 1 m off says more.
TEST(ClustersOf, StatesTheLargestErrorAlsoNextToAWrongHit) {
  RunReport report = Report();
  report.scenarios[0] = Question("a", 1 - 1e-5);
  Finding missed = Known(Fault("a", "ode", 1), 0);
  missed.measure = MeasureKind::kTouching;
  missed.grade = Grade::kWrongTouch;
  Finding count = Known(Fault("b", "ode", 3), 0);
  count.measure = MeasureKind::kContactCount;
  count.grade = Grade::kLarge;
  report.findings = {missed, Known(Fault("b", "ode", 1), 0), count};
  const Clusters clusters = ClustersOf(report);
  ASSERT_EQ(clusters.ranked.size(), 1U);
  EXPECT_EQ(clusters.ranked[0].grade, Grade::kWrongTouch);
  EXPECT_EQ(ExtentOf(report, clusters.ranked[0]),
            "ode, in 2 scenarios, at worst 1 m, 58 % of the smaller body.");
}

TEST(ClustersOf, GroupsNewFaultsByOracleMeasureAndCause) {
  RunReport report = Report();
  Finding tie = Fault("b", "ode", 0.02);
  tie.cause = Cause::kTie;
  Finding crash = Fault("c", "bullet", 1);
  crash.measure = MeasureKind::kAnswering;
  crash.verdict = Verdict::kCrashed;
  crash.grade = Grade::kUnusable;
  crash.cause = Cause::kNone;
  Finding right = Fault("c", "ode", 0);
  right.verdict = Verdict::kPass;
  report.findings = {Fault("a", "ode", 0.01), Fault("b", "ode", 0.03), tie, right, crash};
  const Clusters clusters = ClustersOf(report);
  std::vector<std::string> sentences;
  for (const Cluster& cluster : clusters.ranked) {
    EXPECT_TRUE(cluster.is_new);
    sentences.push_back(cluster.title + " " + ExtentOf(report, cluster));
  }
  // The contrived crash, 6 − 1/2, precedes errors of 1 %, 3, even in two questions.
  EXPECT_THAT(sentences,
              ElementsAre("bullet crashes. In 1 scenario.",
                          "ode states a wrong distance or depth (defect). In "
                          "2 scenarios, at worst 3 cm, 1.7 % of the smaller body.",
                          "ode states a wrong distance or depth (tie). In 1 "
                          "scenario, at worst 2 cm, 1.2 % of the smaller body."));
  EXPECT_THAT(clusters.of_finding, ElementsAre(1, 1, 2, -1, 0));
}

// Bodies at rest touch: that a normal is wrong there is no smaller fault than one of 1 %.
TEST(ClustersOf, RanksAGraveFaultAtATouchBeforeALargeOneElsewhere) {
  RunReport report = Report();
  report.scenarios[2] = Question("c", 1);
  report.findings = {Fault("a", "ode", 0.02), Fault("c", "bullet", 1)};
  const Clusters clusters = ClustersOf(report);
  ASSERT_EQ(clusters.ranked.size(), 2U);
  EXPECT_EQ(clusters.ranked[0].grade, Grade::kGross);
  EXPECT_NEAR(clusters.ranked[0].rank, 4 - 0.5, 1e-12);
  EXPECT_EQ(clusters.ranked[1].rank, 3);
}

TEST(ClustersOf, TellsWhoIsResponsible) {
  RunReport report = Report();
  report.ledger.entries[0].responsible = Responsible::kAdapter;
  Finding model = Fault("b", "ode", 0.02);
  model.cause = Cause::kModel;
  report.findings = {Known(Fault("a", "ode", 0.3), 0), model,
                     Fault("c", "bullet", 0.001)};
  const Clusters clusters = ClustersOf(report);
  ASSERT_EQ(clusters.ranked.size(), 3U);
  EXPECT_EQ(clusters.ranked[0].responsible, Responsible::kAdapter);
  EXPECT_EQ(clusters.ranked[1].responsible, Responsible::kModel);
  EXPECT_EQ(clusters.ranked[2].responsible, Responsible::kEngine);
}

// Three contacts too many are a 300 % of nothing that anybody measures.
TEST(ClustersOf, RanksACountOfContactsBelowAnEqualLength) {
  RunReport report = Report();
  Finding count = Fault("a", "ode", 3);
  count.measure = MeasureKind::kContactCount;
  count.grade = Grade::kLarge;
  report.findings = {count, Fault("a", "bullet", 1)};
  const Clusters clusters = ClustersOf(report);
  ASSERT_EQ(clusters.ranked.size(), 2U);
  EXPECT_EQ(clusters.ranked[0].oracles, std::vector<std::size_t>{1});
  EXPECT_EQ(clusters.ranked[1].grade, Grade::kLarge);
}

TEST(FaultOf, IsTheFirstSentenceOfAReasonThatNamesNone) {
  LedgerEntry entry;
  entry.reason = "It prints 'ODE: e.g. x'. Then it stops.";
  EXPECT_EQ(FaultOf(entry), "It prints 'ODE: e.g. x'.");
  entry.reason = "No stop at the end";
  EXPECT_EQ(FaultOf(entry), "No stop at the end.");
  entry.fault = "It stops.";
  EXPECT_EQ(FaultOf(entry), "It stops.");
}

TEST(ClustersOf, FindsNothingWhereNothingFails) {
  RunReport report = Report();
  report.findings = {Fault("a", "ode", 0)};
  report.findings[0].verdict = Verdict::kPass;
  EXPECT_THAT(ClustersOf(report).ranked, IsEmpty());
}

TEST(ClustersOf, GivesAKnownCrashOnAVariantNoSize) {
  RunReport report = Report();
  report.ledger.entries.resize(1);
  report.ledger.entries[0].verdict = Verdict::kTimedOut;
  report.ledger.entries[0].reason = "It hangs.";
  Finding hang = Fault("a", "ode", 0.3);
  hang.measure = MeasureKind::kSwap;
  hang.verdict = Verdict::kKnown;
  hang.grade = Grade::kUnusable;
  hang.ledger_entry = 0;
  report.findings = {hang};
  const Clusters clusters = ClustersOf(report);
  EXPECT_EQ(clusters.ranked[0].grade, Grade::kUnusable);
  EXPECT_EQ(ExtentOf(report, clusters.ranked[0]), "ode, in 1 scenario.");
}

ContactTruth Separated(double separation) {
  ContactTruth truth;
  truth.separation = {separation, separation};
  return truth;
}

TEST(OrdinaryOf, IsOneForEverydayQuestionsAndFallsWithEachDecadeBeyond) {
  EXPECT_EQ(OrdinaryOf(Cubes(0.9), Separated(-0.1)), 1);
  // An extent of 100 √3 m: log10(17.32) decades above 10 m.
  EXPECT_NEAR(OrdinaryOf(Cubes(90, 50), Separated(-10)), 1 / (1 + std::log10(17.32)),
              1e-3);
  // A gap of half a thousandth of √3 m; nearer than a tenth of it counts no more.
  EXPECT_NEAR(OrdinaryOf(Cubes(1), Separated(std::sqrt(3.0) * 5e-4)),
              1 / (1 + std::log10(2)), 1e-12);
  EXPECT_NEAR(OrdinaryOf(Cubes(1), Separated(std::sqrt(3.0) * 1e-5)), 1.0 / 2, 1e-12);
  EXPECT_NEAR(OrdinaryOf(Cubes(1), Separated(0)), 1.0 / 2, 1e-12);
  // A plate of 1 cm, √2.0001 m from corner to corner: the smaller body.
  ContactQuery plate = Cubes(0.9);
  plate.A.shape = Box{{0.5, 0.5, 0.005}};
  EXPECT_NEAR(OrdinaryOf(plate, Separated(-0.1)),
              1 / (1 + std::log10(std::sqrt(2.0001) / 0.01 / 10)), 1e-12);
}

TEST(OrdinaryOf, OfAWorldLooksAtMassesSpeedsAndTheStep) {
  World world;
  RigidBody body;
  body.placed.shape = Sphere{0.5};
  world.bodies = {body, body};
  EXPECT_EQ(OrdinaryOf(world), 1);
  world.bodies[1].mass = 1000;
  EXPECT_NEAR(OrdinaryOf(world), 0.5, 1e-12);
  world.bodies[1].mass = 1;
  world.bodies[0].v_WB.x() = 2400;  // Ten times its extent in a step of 1/240 s.
  EXPECT_NEAR(OrdinaryOf(world), 0.5, 1e-12);
  world.bodies[0].v_WB.x() = 0;
  world.dt = 1.0 / 3;
  EXPECT_NEAR(OrdinaryOf(world), 0.5, 1e-12);
  EXPECT_EQ(OrdinaryOf(World{}), 1);
}

TEST(FaultInWords, HasWordsForEveryMeasure) {
  for (const MeasureKind measure : AllMeasures())
    EXPECT_NE(FaultInWords(measure), "") << NameOf(measure);
}

TEST(SiQuantity, ChoosesThePrefixOfALength) {
  EXPECT_EQ(SiQuantity(0.048, "m"), "4.8 cm");
  EXPECT_EQ(SiQuantity(0.0099999, "m"), "1 cm");
  EXPECT_EQ(SiQuantity(1.3e-5, "m"), "13 µm");
  EXPECT_EQ(SiQuantity(0.0021, "m"), "2.1 mm");
  EXPECT_EQ(SiQuantity(659.2, "m"), "659 m");
  EXPECT_EQ(SiQuantity(2084, "m"), "2080 m");
  EXPECT_EQ(SiQuantity(99.7, "m"), "100 m");
  EXPECT_EQ(SiQuantity(2e-16, "m"), "2e-16 m");
  EXPECT_EQ(SiQuantity(0.3, "rad"), "0.3 rad");
  EXPECT_EQ(SiQuantity(2, ""), "2");
  EXPECT_EQ(SiQuantity(NAN, "m"), "not a number");
}

TEST(ShareInWords, SaysPerCentWhereThatIsShort) {
  EXPECT_EQ(ShareInWords(0.05, "it"), "5 % of it");
  EXPECT_EQ(ShareInWords(1.02, "it"), "102 % of it");
  EXPECT_EQ(ShareInWords(4.03, "it"), "4 times it");
  EXPECT_EQ(ShareInWords(12, "it"), "12 times it");
  EXPECT_EQ(ShareInWords(2e-5, "it"), "2e-5 of it");
  EXPECT_EQ(ShareInWords(2e-4, "it"), "0.02 % of it");
  EXPECT_EQ(ShareInWords(1.8e6, "it"), "1.8e6 times it");
  EXPECT_EQ(ShareInWords(INFINITY, "it"), "");
}

}  // namespace
}  // namespace touchstone
