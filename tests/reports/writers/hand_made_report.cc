#include "hand_made_report.h"

#include <limits>

#include <Eigen/Geometry>

namespace touchstone {
namespace {

using Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Pose AwkwardPose(double x, double y, double z) {
  return Pose::FromQuaternion({x, y, z}, Eigen::Quaterniond(0.4, -0.2, 0.8, 0.4));
}

Finding Measured(const std::string& scenario, const std::string& oracle,
                 MeasureKind measure, double value, double tolerance, Verdict verdict) {
  Finding finding;
  finding.scenario = scenario;
  finding.oracle = oracle;
  finding.reference = "referee";
  finding.measure = measure;
  finding.value = value;
  finding.tolerance = tolerance;
  finding.tolerance_because = "64 unit roundoffs of the scene";
  finding.verdict = verdict;
  return finding;
}

ContactAnswer Answered(double separation, const Vector3d& n_AB_W, const Vector3d& p_WC) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = separation <= 0;
  answer.separation = separation;
  answer.n_AB_W = n_AB_W;
  if (answer.touching) answer.points.push_back({p_WC, separation, {}});
  return answer;
}

// A sphere sunk 0.05 m into the +z face of a box.
ScenarioResult SphereInBox(const std::string& id) {
  ScenarioResult result;
  result.scenario.id = id;
  result.scenario.title = "A sphere in a <box> & out again";
  result.scenario.source = "Derivation: centre at h + r - d on the face axis";
  const Pose X_WA = AwkwardPose(0.3, -0.7, 1.1);
  const Vector3d n_W = X_WA.R_WB.col(2);
  Body& A = result.scenario.contact.A;
  Body& B = result.scenario.contact.B;
  A = {Box{{0.3, 0.2, 0.1}}, X_WA};
  B = {Sphere{0.25}, Pose::FromQuaternion(X_WA * Vector3d(0.07, -0.03, 0.3),
                                          Eigen::Quaterniond::Identity())};
  result.truth.touching = Touching::kTouching;
  result.truth.separation = {-0.05, -0.05};
  result.truth.certificate = {n_W, X_WA * Vector3d(0.07, -0.03, 0.1),
                              X_WA * Vector3d(0.07, -0.03, 0.05)};
  result.truth.method = "core";
  return result;
}

OracleInfo Named(const std::string& name, double unit_roundoff) {
  OracleInfo info;
  for (auto& row : info.capabilities) {
    for (Capability& capability : row) capability.supported = true;
  }
  info.name = name;
  info.library = "Library of " + name;
  info.version = "1.2";
  info.unit_roundoff = unit_roundoff;
  info.settings.push_back({"depth sign", "negated", "it gives depths"});
  return info;
}

}  // namespace

RunReport HandMadeReport() {
  const std::string deep = "contact/box_sphere/deep";
  const std::string wrong = "contact/box_sphere/wrong";
  const std::string cone = "contact/cone_cone/grazing";

  RunReport report;
  report.subject = "mine";
  report.oracles = {Named("mine", 0x1p-53), Named("theirs/float", 0x1p-24)};

  ScenarioResult first = SphereInBox(deep);
  const Vector3d n_W = first.truth.certificate.n_AB_W;
  const Vector3d p_WC =
      (first.truth.certificate.p_WCa + first.truth.certificate.p_WCb) / 2;
  first.answers = {Answered(-0.05, n_W, p_WC), Answered(-0.0500001, n_W, p_WC)};
  ScenarioResult second = SphereInBox(wrong);
  second.answers = {Answered(-0.04, n_W, p_WC), Answered(kNaN, n_W, p_WC)};
  ScenarioResult third = SphereInBox(cone);
  third.scenario.contact.A.shape = Cone{0.3, 0.2};
  third.scenario.contact.B.shape = HalfSpace{};
  third.truth.touching = Touching::kUndecided;
  ContactAnswer unsupported;
  unsupported.reason = "no cones \x01 here";
  third.answers = {Answered(0, n_W, p_WC), unsupported};
  report.scenarios = {first, second, third};

  report.findings.push_back(Measured(deep, "mine", MeasureKind::kSeparationError, 1e-16,
                                     1e-15, Verdict::kPass));
  Finding known = Measured(deep, "theirs/float", MeasureKind::kSeparationError, 1e-7,
                           1e-8, Verdict::kKnown);
  known.cause = Cause::kPrecision;
  known.cause_because = "its arithmetic has 24 bits";
  known.ledger_entry = 0;
  report.findings.push_back(known);

  Finding fail =
      Measured(wrong, "mine", MeasureKind::kSeparationError, 0.01, 1e-15, Verdict::kFail);
  fail.cause = Cause::kDefect;
  fail.proof = "mine says 0.04 deep; moving B by 0.04 along n leaves 0.01 of overlap";
  report.findings.push_back(fail);
  report.findings.push_back(Measured(wrong, "mine", MeasureKind::kConsistencyError, 0.01,
                                     1e-14, Verdict::kFail));
  report.findings.push_back(Measured(wrong, "theirs/float", MeasureKind::kAnswering, kNaN,
                                     0, Verdict::kInvalid));
  report.findings.back().grade = Grade::kUnusable;

  report.findings.push_back(
      Measured(cone, "mine", MeasureKind::kTouching, 0, 0, Verdict::kUndecidable));
  report.findings.push_back(Measured(cone, "theirs/float", MeasureKind::kAnswering, 0, 0,
                                     Verdict::kUnsupported));

  LedgerEntry entry;
  entry.scenarios = {"contact/box_sphere/*"};
  entry.oracle = "theirs/float";
  entry.version = "1.2";
  entry.measures = {MeasureKind::kSeparationError};
  entry.causes = {Cause::kPrecision};
  entry.reason = "Float build";
  entry.upstream = "unreported";
  entry.expires = "2027-01-01";
  report.ledger.entries = {entry, entry};
  report.ledger.entries[1].scenarios = {"contact/hull_hull/*"};
  report.ledger_use = {{.hidden = {{1, 1e-7, 1e-6}}, .causes = {}, .candidates = 2},
                       {.hidden = {{}}, .causes = {}}};
  report.faults = {
      "contact/box_sphere/deep: the author expects \"apart\", the truth is not"};
  return report;
}

}  // namespace touchstone
