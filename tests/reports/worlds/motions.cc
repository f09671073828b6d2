#include "tests/reports/worlds/motions.h"

#include <algorithm>

#include "reports/worlds/laws/laws.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

OracleInfo EngineOf(std::string name, double unit_roundoff) {
  OracleInfo info;
  info.name = std::move(name);
  info.unit_roundoff = unit_roundoff;
  info.simulates = true;
  return info;
}

}  // namespace

const OracleInfo& DoubleEngine() {
  static const OracleInfo info = EngineOf("engine", 0x1p-53);
  return info;
}

const OracleInfo& FloatEngine() {
  static const OracleInfo info = EngineOf("engine/float", 0x1p-24);
  return info;
}

RigidBody BodyOf(std::string_view name, const Shape& shape, double mass,
                 const Eigen::Vector3d& p_WB) {
  RigidBody body;
  body.name = name;
  body.placed = {shape, Pose::FromQuaternion(p_WB, Eigen::Quaterniond::Identity())};
  body.mass = mass;
  return body;
}

RigidBody GroundOf(const Eigen::Vector3d& n_W) {
  RigidBody ground = BodyOf("ground", HalfSpace{}, 0, Eigen::Vector3d::Zero());
  ground.placed.X_WB = Pose::FromQuaternion(
      Eigen::Vector3d::Zero(),
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), n_W));
  return ground;
}

Trajectory Sampled(const World& world,
                   const std::function<WorldState(double)>& state_at) {
  Trajectory trajectory;
  trajectory.status = AnswerStatus::kAnswered;
  for (int step = 0; step <= world.steps; step += world.sample_every) {
    trajectory.times.push_back(step * world.dt);
    trajectory.samples.push_back(state_at(step * world.dt));
  }
  return trajectory;
}

Trajectory Stepped(const World& world, const std::function<void(WorldState&)>& step) {
  WorldState state = StateAtStart(world);
  int done = 0;
  return Sampled(world, [&](double t) {
    for (; (done + 0.5) * world.dt < t; ++done) step(state);
    return state;
  });
}

Eigen::Quaterniond Turned(const Eigen::Quaterniond& q_WB,
                          const Eigen::Vector3d& angle_W) {
  const double angle = angle_W.norm();
  if (angle == 0) return q_WB;
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, angle_W / angle)) * q_WB;
}

Claim ClaimOf(std::string_view law, std::vector<std::string> about,
              std::map<std::string, double> numbers) {
  return {std::string(law), std::move(about), std::move(numbers), ""};
}

std::vector<LawFinding> Judge(const World& world, const Trajectory& trajectory,
                              const Claim& claim, const OracleInfo& oracle) {
  const Law* law = FindLaw(claim.law);
  EXPECT_NE(law, nullptr) << claim.law;
  if (!law) return {};
  for (const Fault& fault : law->faults(world, claim))
    ADD_FAILURE() << fault.where << " " << fault.what << "; expected " << fault.expected;
  return law->judge({world, oracle, trajectory}, claim);
}

std::vector<Fault> FaultsOf(const World& world, const Claim& claim) {
  const Law* law = FindLaw(claim.law);
  EXPECT_NE(law, nullptr) << claim.law;
  return law ? law->faults(world, claim) : std::vector<Fault>{};
}

LawFinding Of(const std::vector<LawFinding>& findings, MeasureKind measure) {
  const auto is_it = [&](const LawFinding& finding) {
    return finding.measure == measure;
  };
  EXPECT_EQ(std::count_if(findings.begin(), findings.end(), is_it), 1) << NameOf(measure);
  const auto found = std::find_if(findings.begin(), findings.end(), is_it);
  return found == findings.end() ? LawFinding{} : *found;
}

testing::AssertionResult Passes(const std::vector<LawFinding>& findings) {
  if (findings.empty()) return testing::AssertionFailure() << "nothing was measured";
  for (const LawFinding& finding : findings) {
    if (finding.value <= finding.tolerance.value) continue;
    return testing::AssertionFailure()
           << NameOf(finding.measure) << " is " << finding.value << ", tolerance "
           << finding.tolerance.value << ": " << finding.proof << " ["
           << finding.recognised << "]";
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult Finds(const std::vector<LawFinding>& findings,
                               MeasureKind measure) {
  const LawFinding finding = Of(findings, measure);
  if (finding.value <= finding.tolerance.value) {
    return testing::AssertionFailure() << NameOf(measure) << " is " << finding.value
                                       << ", tolerance " << finding.tolerance.value;
  }
  if (!finding.recognised.empty())
    return testing::AssertionFailure() << "recognised: " << finding.recognised;
  return testing::AssertionSuccess() << finding.proof;
}

}  // namespace touchstone
