#include "reports/run.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scenario ScenarioOf(std::string id, const ContactQuery& query) {
  Scenario scenario;
  scenario.id = std::move(id);
  scenario.contact = query;
  return scenario;
}

/** Numbers in [lo, hi) that are the same on every machine. */
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

/** Random questions over every pair of spheres, boxes, capsules, hulls and a half-space.
 */
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
  EXPECT_EQ(ExitCode(report, FailOn::kAnything), 0);
  // The sweep touched something, and left something apart.
  const auto touching = std::count_if(
      report.scenarios.begin(), report.scenarios.end(), [](const ScenarioResult& result) {
        return result.truth.touching == Touching::kTouching;
      });
  EXPECT_GT(touching, static_cast<long>(scenarios.size() / 4));
  EXPECT_LT(touching, static_cast<long>(scenarios.size() * 9 / 10));
}

}  // namespace
}  // namespace touchstone
