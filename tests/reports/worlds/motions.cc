#include "tests/reports/worlds/motions.h"

#include <algorithm>
#include <cmath>

#include "reports/worlds/laws/laws.h"
#include "reports/worlds/truth/mechanics.h"
#include "tests/reports/worlds/unmistakable.h"

namespace touchstone {
namespace {

OracleInfo EngineOf(std::string name, double unit_roundoff) {
  OracleInfo info;
  info.name = std::move(name);
  info.unit_roundoff = unit_roundoff;
  info.simulates = true;
  return info;
}

enum class ErrorKind { kPlace, kVelocity, kOrientation, kSpin, kImpulse };

/** Returns `v` lengthened by `size`, or a vector of that length if it is zero. */
Eigen::Vector3d Lengthened(const Eigen::Vector3d& v, double size) {
  return v.isZero(0) ? Eigen::Vector3d(size, 0, 0)
                     : Eigen::Vector3d(v + size * v.normalized());
}

void AddError(ErrorKind kind, double size, const Eigen::Vector3d& off_W,
              BodyState& body) {
  switch (kind) {
    case ErrorKind::kPlace:
      body.p_WB += off_W;
      break;
    case ErrorKind::kVelocity:
      body.v_WB = Lengthened(body.v_WB, size);
      break;
    case ErrorKind::kOrientation:
      // Beyond half a turn a larger error is a smaller one.
      body.q_WB = Turned(body.q_WB, std::min(size, 3.0) * Eigen::Vector3d::UnitX());
      break;
    case ErrorKind::kSpin:
      body.w_WB = Lengthened(body.w_WB, size);
      break;
    case ErrorKind::kImpulse:
      break;
  }
}

Trajectory WithError(const World& world, Trajectory motion, ErrorKind kind, double size,
                     const Eigen::Vector3d& direction) {
  const Eigen::Vector3d off_W = size * direction.normalized();
  for (std::size_t s = motion.samples.size() / 2 + 1; s < motion.samples.size(); ++s) {
    WorldState& state = motion.samples[s];
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
      if (world.bodies[i].mass > 0) AddError(kind, size, off_W, state.bodies[i]);
    }
    for (std::vector<PointState>* points : {&state.particles, &state.nodes}) {
      for (PointState& point : *points) {
        if (kind == ErrorKind::kPlace) point.p_W += off_W;
        if (kind == ErrorKind::kVelocity) point.v_W = Lengthened(point.v_W, size);
      }
    }
  }
  if (kind == ErrorKind::kImpulse) {
    for (ContactImpulse& contact : motion.impulses) contact.J_B_W += off_W;
  }
  return motion;
}

/** Succeeds if every finding beyond its tolerance cites what its sentence names. A wrong
 position is shown as two points. */
testing::AssertionResult FaultsCiteWhatTheySay(const World& world,
                                               const std::vector<LawFinding>& findings) {
  for (const LawFinding& finding : findings) {
    if (!IsBeyond(finding)) continue;
    const testing::AssertionResult cites =
        CitesWhatItSays(world, finding.proof, finding.cited);
    if (!cites) return cites;
    const bool shows_vectors = finding.proof.find('(') != std::string::npos;
    if (finding.measure == MeasureKind::kPositionError && shows_vectors &&
        finding.cited.points_W.size() != 2)
      return testing::AssertionFailure() << "cites no two points: " << finding.proof;
  }
  return testing::AssertionSuccess();
}

bool Fails(const std::vector<LawFinding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const LawFinding& finding) {
    return finding.recognised.empty() && IsBeyond(finding);
  });
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

World BallOnRoughGround() {
  World world;
  world.bodies = {BodyOf("ball", Sphere{0.2}, 1, {0, 0.2, 0}), GroundOf()};
  world.bodies[0].friction = 0.25;  // The friction of two bodies is √(μ_A μ_B).
  world.bodies[1].friction = 1;
  world.steps = 10;
  return world;
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
    if (!IsBeyond(finding)) continue;
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
  if (!IsBeyond(finding)) {
    return testing::AssertionFailure() << NameOf(measure) << " is " << finding.value
                                       << ", tolerance " << finding.tolerance.value;
  }
  if (!finding.recognised.empty())
    return testing::AssertionFailure() << "recognised: " << finding.recognised;
  return testing::AssertionSuccess() << finding.proof;
}

testing::AssertionResult TurnsOnce(const World& of_test, const Trajectory& right,
                                   const Claim& claim_of_test,
                                   const Eigen::Vector3d& direction,
                                   const OracleInfo& oracle) {
  const auto [world, claim] = WithUnmistakableNames(of_test, claim_of_test);
  const testing::AssertionResult passes = Passes(Judge(world, right, claim, oracle));
  if (!passes) return passes;
  bool any_fails = false;
  for (const ErrorKind kind :
       {ErrorKind::kPlace, ErrorKind::kVelocity, ErrorKind::kOrientation,
        ErrorKind::kSpin, ErrorKind::kImpulse}) {
    double failed_at = 0;
    for (int halves = -30; halves <= 10; ++halves) {
      const double size = std::pow(10, halves / 2.0);
      const Trajectory wrong = WithError(world, right, kind, size, direction);
      const std::vector<LawFinding> findings = Judge(world, wrong, claim, oracle);
      const testing::AssertionResult cites = FaultsCiteWhatTheySay(world, findings);
      if (!cites) return cites;
      const bool fails = Fails(findings);
      if (fails && failed_at == 0) failed_at = size;
      if (!fails && failed_at > 0) {
        return testing::AssertionFailure()
               << "an error of kind " << static_cast<int>(kind) << " fails at a size of "
               << failed_at << " and passes at " << size << ": " << findings.front().value
               << " of " << findings.front().tolerance.value << ", "
               << findings.front().proof;
      }
    }
    any_fails = any_fails || failed_at > 0;
  }
  if (!any_fails) return testing::AssertionFailure() << "no error fails";
  return testing::AssertionSuccess();
}

}  // namespace touchstone
