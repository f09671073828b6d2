#include "reports/run.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/ledger/check_catalogue.h"
#include "reports/referee/referee.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scenario ScenarioOf(std::string id, const ContactQuery& query) {
  Scenario scenario;
  scenario.id = std::move(id);
  scenario.contact = query;
  return scenario;
}

/** A random generator that is the same on every machine. */
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double Uniform(double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  Eigen::Vector3d Vector(double lo, double hi) {
    const double x = Uniform(lo, hi);
    const double y = Uniform(lo, hi);
    return {x, y, Uniform(lo, hi)};
  }
  Pose AnyPose(double reach) {
    const Eigen::Vector3d p = Vector(-reach, reach);
    const Eigen::Vector3d axis = Vector(-1, 1);
    const double w = Uniform(-1, 1);
    return Pose::FromQuaternion(
        p, Eigen::Quaterniond(w, axis.x(), axis.y(), axis.z()).normalized());
  }
  Shape AnyShape(int kind) {
    switch (kind) {
      case 0:
        return Sphere{Uniform(0.1, 0.6)};
      case 1:
        return Box{Vector(0.1, 0.6)};
      case 2: {
        const double radius = Uniform(0.1, 0.4);
        return Capsule{radius, Uniform(0.1, 0.5)};
      }
      case 3: {
        ConvexHull hull;
        for (int i = 0; i < 9; ++i) hull.vertices.push_back(Vector(-0.5, 0.5));
        return hull;
      }
      default:
        return HalfSpace{};
    }
  }

 private:
  std::mt19937_64 engine_;
};

/** Returns random questions over every pair of spheres, boxes, capsules, hulls and a
 half-space. */
std::vector<Scenario> Sweep(int rounds) {
  Random random(20250317);
  std::vector<Scenario> scenarios;
  for (int round = 0; round < rounds; ++round) {
    for (int a = 0; a < 5; ++a) {
      for (int b = 0; b < 5 - (a == 4); ++b) {
        ContactQuery query{{random.AnyShape(a), random.AnyPose(0.3)},
                           {random.AnyShape(b), random.AnyPose(0.5)}};
        scenarios.push_back(
            ScenarioOf("sweep/" + std::to_string(scenarios.size()), query));
      }
    }
  }
  return scenarios;
}

RunReport RunAll(const std::vector<Scenario>& scenarios,
                 std::initializer_list<const Oracle*> oracles, const Ledger& ledger = {},
                 const RunOptions& options = {}) {
  const std::vector<const Oracle*> asked(oracles);
  return Run(scenarios, asked, ledger, options);
}

std::vector<std::string> ProofsOfFailures(const RunReport& report) {
  std::vector<std::string> proofs;
  for (const Finding& finding : report.findings) {
    if (finding.verdict == Verdict::kPass || finding.verdict == Verdict::kUndecidable)
      continue;
    proofs.push_back(finding.scenario + ": " + std::string(NameOf(finding.measure)) +
                     ": " + finding.proof + " (" + std::to_string(finding.value) + ")");
  }
  return proofs;
}

TEST(Run, RaisesNoFalseAlarmOnARightOracle) {
  const std::vector<Scenario> scenarios = Sweep(20);
  const FakeOracle right("right");
  const RunReport report = RunAll(scenarios, {&right});
  EXPECT_THAT(ProofsOfFailures(report), IsEmpty());
  EXPECT_THAT(report.faults, IsEmpty());
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kAnything}), 0);
  // The sweep contains both touching and separated bodies.
  const auto touching = std::count_if(
      report.scenarios.begin(), report.scenarios.end(), [](const ScenarioResult& result) {
        return result.truth.touching == Touching::kTouching;
      });
  EXPECT_GT(touching, static_cast<long>(scenarios.size() / 4));
  EXPECT_LT(touching, static_cast<long>(scenarios.size() * 9 / 10));
}

/** Returns everything in which two reports could differ, as text. */
std::string Digest(const RunReport& report) {
  std::string text;
  for (const Finding& f : report.findings) {
    text += f.scenario + f.oracle + std::string(NameOf(f.measure)) +
            std::string(NameOf(f.verdict)) + std::string(NameOf(f.cause)) + f.proof +
            f.cause_because + std::to_string(f.value) + "\n";
  }
  for (const std::string& fault : report.faults) text += fault + "\n";
  return text;
}

TEST(Run, DoesNotDependOnTheNumberOfJobs) {
  const std::vector<Scenario> scenarios = Sweep(4);
  const FakeOracle right("right");
  const FakeOracle wrong = FakeOracle::Wrong(
      "wrong",
      [](const ContactQuery&, ContactAnswer& answer) { *answer.separation *= 0.5; });
  RunOptions one;
  one.jobs = 1;
  RunOptions many;
  many.jobs = 5;
  const RunReport serial = RunAll(scenarios, {&right, &wrong}, {}, one);
  const RunReport parallel = RunAll(scenarios, {&right, &wrong}, {}, many);
  EXPECT_EQ(Digest(serial), Digest(parallel));
  EXPECT_NE(ExitCode(serial, {.whose = FailOn::kAnything}), 0);
}

TEST(Run, AddsUpTheSecondsOfContactQueriesByKind) {
  const FakeOracle slow = FakeOracle::Wrong(
      "slow", [](const ContactQuery&, ContactAnswer& answer) { answer.seconds = 1; });
  const std::vector<Scenario> scenarios = Sweep(1);
  const RunReport report = RunAll(scenarios, {&slow}, {}, {});
  EXPECT_EQ(SecondsOf(report, 0, 0), 1);
  const auto count = static_cast<double>(scenarios.size());
  EXPECT_EQ(report.seconds_of_contacts.at("itself"), count);
  EXPECT_EQ(report.seconds_of_contacts.at("swap"), count);
  EXPECT_GT(report.seconds_of_contacts.at("truth"), 0);
}

TEST(Run, SortsByScenarioOracleAndMeasure) {
  const FakeOracle second("b");
  const FakeOracle first("z");
  std::vector<Scenario> scenarios = {
      ScenarioOf("contact/y", BoxOnBoxFace(1e-3).query),
      ScenarioOf("contact/x", SphereInBoxFace(1e-3).query)};
  const RunReport report = RunAll(scenarios, {&first, &second});
  EXPECT_EQ(report.subject, "z");
  EXPECT_EQ(report.scenarios[0].scenario.id, "contact/x");
  const auto place = [](const Finding& f) {
    return std::tuple(f.scenario, f.oracle == "z" ? 0 : 1, f.measure);
  };
  EXPECT_TRUE(std::is_sorted(
      report.findings.begin(), report.findings.end(),
      [&](const Finding& a, const Finding& b) { return place(a) < place(b); }));
  EXPECT_EQ(report.findings.front().oracle, "z");
  EXPECT_EQ(report.findings.back().oracle, "b");
}

TEST(Run, ReportsProgressUpToAllPairs) {
  const FakeOracle first("a");
  const FakeOracle second("b");
  std::vector<std::tuple<std::size_t, std::size_t, double>> calls;
  RunOptions options;
  options.on_progress = [&](std::size_t done, std::size_t total, double part) {
    calls.emplace_back(done, total, part);
  };
  RunAll(Sweep(4), {&first, &second}, {}, options);
  ASSERT_FALSE(calls.empty());
  EXPECT_EQ(calls.front(), std::tuple(std::size_t{0}, std::size_t{192}, 0.0));
  ASSERT_GT(calls.size(), 2U);
  EXPECT_GT(std::get<2>(calls[1]), 0);
  EXPECT_LT(std::get<2>(calls[1]), 1);
  EXPECT_EQ(calls.back(), std::tuple(std::size_t{192}, std::size_t{192}, 1.0));
  EXPECT_TRUE(std::is_sorted(calls.begin(), calls.end()));
}

TEST(Run, AsksNoQuestionThatAnOracleDoesNotSupport) {
  FakeOracle none = FakeOracle::Wrong(
      "none", [](const ContactQuery&, ContactAnswer&) { ADD_FAILURE() << "was asked"; });
  none.ForEachPair([](Capability& capability) {
    capability.supported = false;
    capability.reason = "no such pair";
  });
  none.info().capabilities[0][0].supported =
      true;  // Two spheres are supported, so that it answers contact queries.
  const RunReport report =
      RunAll({ScenarioOf("contact/x", SphereInBoxFace(1e-3).query)}, {&none});
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].verdict, Verdict::kUnsupported);
  EXPECT_EQ(report.findings[0].proof, "none: no such pair.");
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kAnything}), 2);
  // A wrong reference does not make the subject examined either.
  const FakeOracle wrong = FakeOracle::Wrong(
      "wrong",
      [](const ContactQuery&, ContactAnswer& answer) { *answer.separation *= 0.5; });
  const RunReport beside =
      RunAll({ScenarioOf("contact/x", SphereInBoxFace(1e-3).query)}, {&none, &wrong});
  EXPECT_EQ(ExitCode(beside, {.whose = FailOn::kAnything}), 2);
  EXPECT_EQ(ExitCode(beside, {.whose = FailOn::kSubject}), 2);
}

/** An isolated oracle that records the batches of its questions, by the x of B. */
class Recorder final : public FakeOracle {
 public:
  Recorder() : FakeOracle("recorder") { info().isolated = true; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    std::vector<double> batch;
    batch.reserve(queries.size());
    for (const ContactQuery& query : queries) batch.push_back(query.B.X_WB.p_WB.x());
    {
      const std::scoped_lock lock(recording_);
      batches.push_back(std::move(batch));
    }
    FakeOracle::Answer(queries, answers);
  }
  mutable std::vector<std::vector<double>> batches;

 private:
  mutable std::mutex recording_;
};

/** Returns the batches that `jobs` threads put to an isolated oracle that answers twelve
 questions right. B is at x = 10 to 21. */
std::vector<std::vector<double>> BatchesOf(int jobs) {
  std::vector<Scenario> scenarios;
  for (int i = 0; i < 12; ++i) {
    const Body ball{Sphere{0.5},
                    Pose::FromMatrix({10.0 + i, 0.3, 0.2}, Eigen::Matrix3d::Identity())};
    scenarios.push_back(ScenarioOf(
        "contact/" + std::string(1, static_cast<char>('a' + i)),
        {{Sphere{0.5}, Pose::FromMatrix({0.1, 0.2, 0.3}, Eigen::Matrix3d::Identity())},
         ball}));
  }
  const Recorder recorder;
  RunOptions options;
  options.jobs = jobs;
  const RunReport report = RunAll(scenarios, {&recorder}, {}, options);
  EXPECT_THAT(ProofsOfFailures(report), IsEmpty());
  return recorder.batches;
}

// Hangs of an engine come in rows of like questions, and each costs seconds.
TEST(Run, DealsNeighbouringQuestionsToDifferentBatchesOfAnIsolatedOracle) {
  const std::vector<std::vector<double>> batches = BatchesOf(2);
  EXPECT_THAT(batches, Contains(ElementsAre(10, 18)));
  EXPECT_THAT(batches, Contains(ElementsAre(13, 21)));
  EXPECT_THAT(batches, Contains(ElementsAre(14)));
}

// Each batch is a fork, and one thread shares the time with nobody.
TEST(Run, OfOneThreadPutsAllQuestionsToAnIsolatedOracleAtOnce) {
  const std::vector<std::vector<double>> batches = BatchesOf(1);
  ASSERT_EQ(batches.size(), 2U);  // The questions, and their variants.
  EXPECT_THAT(batches[0], ElementsAre(10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21));
}

TEST(ExitCode, IsTwoWhenNothingWasAsked) {
  const FakeOracle right("right");
  EXPECT_EQ(ExitCode(RunAll({}, {&right}), {.whose = FailOn::kAnything}), 2);
}

TEST(ExitCode, IsTwoWhereOnlyVariantsAgreeAndAClaimIsUnverified) {
  RunReport report;
  report.subject = "right";
  Finding variant;
  variant.scenario = "mine/flight";
  variant.oracle = "right";
  variant.measure = MeasureKind::kTranslation;
  report.findings = {variant};
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kAnything}), 0);
  Finding unverified = variant;
  unverified.reference = "law";
  unverified.verdict = Verdict::kUnsupported;
  report.findings.push_back(unverified);
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kAnything}), 2);
  Finding held = unverified;
  held.verdict = Verdict::kPass;
  report.findings.push_back(held);
  EXPECT_EQ(ExitCode(report, {.whose = FailOn::kAnything}), 0);
}

TEST(ExitCode, CountsTheReferencesOnlyOnRequest) {
  const FakeOracle right("right");
  const FakeOracle wrong = FakeOracle::Wrong(
      "wrong",
      [](const ContactQuery&, ContactAnswer& answer) { *answer.separation *= 0.5; });
  const std::vector<Scenario> scenarios = {
      ScenarioOf("contact/x", SphereInBoxFace(1e-3).query)};
  EXPECT_EQ(ExitCode(RunAll(scenarios, {&right, &wrong}), {.whose = FailOn::kSubject}),
            0);
  EXPECT_EQ(ExitCode(RunAll(scenarios, {&right, &wrong}), {.whose = FailOn::kAnything}),
            1);
  EXPECT_EQ(ExitCode(RunAll(scenarios, {&wrong, &right}), {.whose = FailOn::kSubject}),
            1);
}

/** Returns the exit code where `subject` and `reference` are asked for a separation. */
int CodeOf(const Oracle& subject, const Oracle& reference, const FailureRule& rule) {
  const std::vector<Scenario> scenarios = {
      ScenarioOf("contact/x", SphereInBoxFace(1e-3).query)};
  return ExitCode(RunAll(scenarios, {&subject, &reference}), rule);
}

/** Returns an oracle with an error of `error` in its separation. [m] */
FakeOracle OffBy(double error) {
  return FakeOracle::Wrong("off", [error](const ContactQuery&, ContactAnswer& answer) {
    *answer.separation += error;
  });
}

// Another engine's last digits must not fail a user's run.
TEST(ExitCode, LeavesOutReferencesThatAreWrongByARounding) {
  const FakeOracle right("right");
  const FakeOracle inexact = OffBy(1e-9);
  EXPECT_EQ(CodeOf(right, inexact, {}), 0);
  EXPECT_EQ(CodeOf(right, inexact, {.whose = FailOn::kAnything}), 1);
  EXPECT_EQ(CodeOf(inexact, right, {}), 1);
  EXPECT_EQ(CodeOf(right, OffBy(1e-4), {}), 1);
}

TEST(ExitCode, IsOfFailuresAboveAGrade) {
  const FakeOracle right("right");
  const FakeOracle wrong = OffBy(1e-4);
  for (const auto& [subject, reference] :
       {std::pair<const Oracle&, const Oracle&>(right, wrong), {wrong, right}}) {
    EXPECT_EQ(CodeOf(subject, reference, {.above = Grade::kRounding}), 1);
    EXPECT_EQ(CodeOf(subject, reference, {.above = Grade::kSmall}), 0);
  }
}

// A depth that is off in the last digits decides the verdict before a missing contact.
TEST(ExitCode, IsOfTheGravestFindingOfAnAnswer) {
  const FakeOracle right("right");
  RunReport report =
      RunAll({ScenarioOf("contact/x", SphereInBoxFace(1e-3).query)}, {&right});
  for (Finding& finding : report.findings) {
    if (finding.measure == MeasureKind::kSeparationError)
      std::tie(finding.verdict, finding.grade) =
          std::pair(Verdict::kFail, Grade::kRounding);
    if (finding.measure == MeasureKind::kContactCount)
      std::tie(finding.verdict, finding.grade) = std::pair(Verdict::kFail, Grade::kLarge);
  }
  EXPECT_EQ(ExitCode(report, {.above = Grade::kSmall}), 1);
  EXPECT_EQ(ExitCode(report, {.above = Grade::kLarge}), 0);
}

/** Returns the radius of the sphere of a question. [m] */
double RadiusOf(const ContactQuery& query) {
  const Sphere* B = std::get_if<Sphere>(&query.B.shape);
  return B ? B->radius : std::get<Sphere>(query.A.shape).radius;
}

/** Returns the failures against the referee of one oracle, whose answers `plant` spoils,
 to spheres of `radii` [m] that are 1, 2, … mm deep in a face of a box. */
std::vector<Finding> FailuresOf(
    std::function<void(const ContactQuery&, ContactAnswer&)> plant,
    const std::vector<double>& radii = {0.2, 0.3, 0.4}, const RunOptions& options = {}) {
  const FakeOracle wrong = FakeOracle::Wrong("wrong", std::move(plant));
  std::vector<Scenario> scenarios;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double depth = 1e-3 * static_cast<double>(i + 1);
    ContactQuery query = SphereInBoxFace(depth).query;
    Pose& X_WB = query.B.X_WB;
    X_WB.p_WB += (radii[i] - RadiusOf(query)) * query.A.X_WB.R_WB.col(2);
    query.B.shape = Sphere{radii[i]};
    scenarios.push_back(ScenarioOf("contact/" + std::to_string(i), query));
  }
  std::vector<Finding> failures;
  for (const Finding& finding : RunAll(scenarios, {&wrong}, {}, options).findings) {
    if (finding.verdict == Verdict::kFail && finding.reference == "referee")
      failures.push_back(finding);
  }
  EXPECT_FALSE(failures.empty());
  return failures;
}

/** Returns the causes of these failures. */
std::vector<Cause> CausesOf(
    std::function<void(const ContactQuery&, ContactAnswer&)> plant,
    const std::vector<double>& radii = {0.2, 0.3, 0.4}) {
  std::vector<Cause> causes;
  for (const Finding& finding : FailuresOf(std::move(plant), radii))
    causes.push_back(finding.cause);
  return causes;
}

void HalveTheDepth(ContactAnswer& answer) {
  *answer.separation *= 0.5;
  for (ContactPoint& contact : answer.points) contact.separation *= 0.5;
}

TEST(Run, CallsAHalvedDepthAConvention) {
  EXPECT_THAT(
      CausesOf([](const ContactQuery&, ContactAnswer& answer) { HalveTheDepth(answer); }),
      testing::Each(Cause::kConvention));
}

TEST(Run, CallsNothingAConventionThatOneGeometryShows) {
  for (const Finding& finding : FailuresOf(
           [](const ContactQuery&, ContactAnswer& answer) { HalveTheDepth(answer); },
           {0.3})) {
    EXPECT_EQ(finding.cause, Cause::kDefect);
    EXPECT_THAT(finding.cause_because, HasSubstr("one geometry shows no convention"));
  }
}

TEST(Run, LeavesAConventionOpenThatFailuresBeyondTheLimitMayShow) {
  RunOptions options;
  options.examined_per_kind = 1;
  for (const Finding& finding : FailuresOf(
           [](const ContactQuery&, ContactAnswer& answer) { HalveTheDepth(answer); },
           {0.2, 0.3, 0.4}, options))
    EXPECT_EQ(finding.cause, Cause::kNotExamined) << finding.scenario;
}

TEST(Run, CallsNothingAConventionThatAnotherAnswerContradicts) {
  const auto halve_two = [](const ContactQuery& query, ContactAnswer& answer) {
    if (RadiusOf(query) < 0.35) HalveTheDepth(answer);
  };
  for (const Finding& finding : FailuresOf(halve_two)) {
    EXPECT_EQ(finding.cause, Cause::kDefect);
    EXPECT_THAT(finding.cause_because, HasSubstr("contact/2 contradicts"));
  }
}

TEST(Run, CallsAnErrorOfTheSameLengthEverywhereAMargin) {
  EXPECT_THAT(CausesOf([](const ContactQuery&, ContactAnswer& answer) {
                *answer.separation -= 0.04;
              }),
              testing::Contains(Cause::kConvention));
}

TEST(Run, CallsNoiseFromRoundingADefect) {
  // The last bits of the question decide whether the answer is right, but no question
  // near it has an answer that is so far off.
  EXPECT_THAT(CausesOf([](const ContactQuery& query, ContactAnswer& answer) {
                const Eigen::Vector3d& p_WB = query.B.X_WB.p_WB;
                const double bits = std::sin(p_WB.dot(Eigen::Vector3d(3e17, 5e17, 7e17)));
                if (bits < 0.8) *answer.separation *= 1.5 + 0.4 * bits;
              }),
              testing::Each(Cause::kDefect));
}

TEST(Run, CallsTheRestADefect) {
  EXPECT_THAT(CausesOf([](const ContactQuery&, ContactAnswer& answer) {
                *answer.separation *= 1.3;
              }),
              testing::Each(Cause::kDefect));
}

RunReport Indicting(const Oracle& oracle, bool reproduces,
                    MeasureKind measure = MeasureKind::kSeparationError) {
  Scenario scenario = ScenarioOf("contact/x", SphereInBoxFace(1e-3).query);
  scenario.indicts = {{oracle.info().name, {measure}, "the depth is halved", reproduces},
                      {"somebody/absent", {measure}, "is not here", true}};
  return RunAll({scenario}, {&oracle});
}

TEST(CheckCatalogue, DoubtsAClaimOfStabilityThatEachEngineBreaks) {
  const auto faults_with = [](Verdict first, Verdict second) {
    RunReport report;
    for (const Verdict verdict : {first, second}) {
      Finding finding;
      finding.scenario = "world/x";
      finding.measure = MeasureKind::kStability;
      finding.verdict = verdict;
      report.findings.push_back(finding);
    }
    CheckCatalogue(report);
    return report.faults;
  };
  EXPECT_THAT(faults_with(Verdict::kFail, Verdict::kPass), IsEmpty());
  EXPECT_THAT(
      faults_with(Verdict::kFail, Verdict::kKnown),
      ElementsAre(testing::HasSubstr("world/x: claims to be stable, but each of 2")));
}

TEST(CheckCatalogue, RequiresIndictmentsToBeReproduced) {
  const FakeOracle right("right");
  const FakeOracle wrong = FakeOracle::Wrong(
      "wrong",
      [](const ContactQuery&, ContactAnswer& answer) { *answer.separation *= 0.5; });
  EXPECT_THAT(Indicting(wrong, true).faults, IsEmpty());
  EXPECT_THAT(Indicting(right, false).faults, IsEmpty());
  EXPECT_THAT(
      Indicting(right, true).faults,
      ElementsAre("contact/x: indicts right of separation_error (\"the depth is "
                  "halved\"), which is not reproduced: remove the measure, or set "
                  "reproduces = false."));
  const RunReport found = Indicting(wrong, false);
  ASSERT_EQ(found.faults.size(), 1U);
  EXPECT_THAT(found.faults[0],
              HasSubstr("wrong no longer shows \"the depth is halved\", but "
                        "separation_error still finds it: wrong says 0.0005 m deep"));
  EXPECT_EQ(ExitCode(Indicting(right, true), {.whose = FailOn::kSubject}), 1);
}

TEST(CheckCatalogue, CountsOnlyTheIndictedMeasure) {
  const FakeOracle halved = FakeOracle::Wrong(
      "halved",
      [](const ContactQuery&, ContactAnswer& answer) { *answer.separation *= 0.5; });
  EXPECT_THAT(Indicting(halved, false, MeasureKind::kExcess).faults, IsEmpty());
  EXPECT_THAT(Indicting(halved, true, MeasureKind::kExcess).faults,
              ElementsAre(HasSubstr("indicts halved of excess")));
}

TEST(CheckCatalogue, RequiresAFixedIndictmentToBeMeasured) {
  const FakeOracle right("right");
  EXPECT_THAT(Indicting(right, false, MeasureKind::kDualityGap).faults,
              ElementsAre(HasSubstr("but duality_gap is not measured there")));
}

TEST(CheckCatalogue, RequiresEveryMeasureOfAnIndictment) {
  const FakeOracle halved = FakeOracle::Wrong(
      "halved",
      [](const ContactQuery&, ContactAnswer& answer) { *answer.separation *= 0.5; });
  Scenario scenario = ScenarioOf("contact/x", SphereInBoxFace(1e-3).query);
  scenario.indicts = {{"halved",
                       {MeasureKind::kSeparationError, MeasureKind::kExcess},
                       "the depth is halved",
                       true}};
  EXPECT_THAT(RunAll({scenario}, {&halved}).faults,
              ElementsAre(HasSubstr("indicts halved of excess")));
}

TEST(CheckCatalogue, RequiresIndictmentsOfWorldsToBeReproduced) {
  RunReport report;
  report.oracles.emplace_back().name = "ode";
  report.worlds.emplace_back().scenario.id = "world/x";
  report.worlds[0].scenario.indicts = {
      {"ode", {MeasureKind::kRestMotion}, "It sinks.", true}};
  CheckCatalogue(report);
  EXPECT_THAT(report.faults,
              ElementsAre(HasSubstr("world/x: indicts ode of rest_motion")));

  report.faults.clear();
  Finding finding{};
  finding.scenario = "world/x";
  finding.oracle = "ode";
  finding.measure = MeasureKind::kRestMotion;
  finding.verdict = Verdict::kFail;
  report.findings = {finding};
  CheckCatalogue(report);
  EXPECT_THAT(report.faults, IsEmpty());
}

std::vector<std::string> FaultsWith(const ContactExpectation& expect,
                                    const Specimen& specimen = BoxOnBoxFace(1e-3)) {
  const FakeOracle right("right");
  Scenario scenario = ScenarioOf("contact/x", specimen.query);
  scenario.expect = expect;
  return RunAll({scenario}, {&right}).faults;
}

TEST(CheckCatalogue, AcceptsExpectationsThatAreTrue) {
  ContactExpectation expect;
  expect.touching = true;
  expect.separation = -1e-3;
  expect.normals = {AwkwardPose().R_WB.col(2)};
  expect.contacts = 4;
  EXPECT_THAT(FaultsWith(expect), IsEmpty());
}

TEST(CheckCatalogue, RefutesExpectationsThatAreFalse) {
  ContactExpectation expect;
  expect.touching = false;
  EXPECT_THAT(FaultsWith(expect), ElementsAre(HasSubstr("expects touching = false")));
  expect = {};
  expect.separation = -1.0001e-3;
  EXPECT_THAT(FaultsWith(expect),
              ElementsAre(HasSubstr("expects separation = -0.0010001 m")));
  expect = {};
  expect.normals = {AwkwardPose().R_WB.col(0)};
  EXPECT_THAT(FaultsWith(expect), ElementsAre(HasSubstr("expects the normal ")));
  expect = {};
  expect.contacts = 1;
  EXPECT_THAT(
      FaultsWith(expect),
      ElementsAre(HasSubstr("expects 1 contact, but it takes 4 to span the patch")));
  // If the bodies are apart, the patch is where they would touch.
  EXPECT_THAT(FaultsWith(expect, BoxOnBoxFace(-1e-3)),
              ElementsAre(HasSubstr("expects 1 contact, but it takes 4")));
}

/** Returns the faults of a file that expects `touching` of two cubes, whose faces are
 exactly `gap` apart. */
std::vector<std::string> FaultsOfCubes(double gap, bool touching) {
  const Body cube{Box{{0.5, 0.5, 0.5}}, {}};
  Body other = cube;
  other.X_WB.p_WB = {0, 0, 1 + gap};
  RunReport report;
  ScenarioResult& result = report.scenarios.emplace_back();
  result.scenario = ScenarioOf("contact/x", {cube, other});
  result.scenario.expect.touching = touching;
  result.truth = ComputeContactTruth(result.scenario.contact);
  CheckCatalogue(report);
  return report.faults;
}

// So that an engine with `<` for `<=` is caught.
TEST(CheckCatalogue, DecidesWhetherBodiesTouchWhereNothingIsRounded) {
  EXPECT_THAT(FaultsOfCubes(0, true), IsEmpty());
  EXPECT_THAT(FaultsOfCubes(0, false),
              ElementsAre(HasSubstr("expects touching = false, but")));
  EXPECT_THAT(FaultsOfCubes(0x1p-20, false), IsEmpty());
}

TEST(CheckCatalogue, FaultsAnExpectationThatCannotBeChecked) {
  ContactExpectation expect;
  expect.touching = true;
  EXPECT_THAT(FaultsWith(expect, BoxOnBoxFace(0)),
              ElementsAre(HasSubstr("expects touching = true, which cannot be checked")));
  RunReport report;
  ScenarioResult result;
  result.scenario = ScenarioOf("contact/x", BoxOnBoxFace(1e-3).query);
  result.scenario.expect.separation = -1e-3;
  result.scenario.expect.contacts = 4;
  result.truth = ComputeContactTruth(result.scenario.contact);
  result.truth.separation = {-2e-3, -0.5e-3};
  report.scenarios = {result};
  CheckCatalogue(report);
  EXPECT_THAT(
      report.faults,
      ElementsAre(HasSubstr("expects separation = -0.001 m, which cannot be checked"),
                  HasSubstr("expects 4 contacts, which cannot be checked")));
}

}  // namespace
}  // namespace touchstone
