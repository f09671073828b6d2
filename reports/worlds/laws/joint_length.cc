#include <algorithm>
#include <cmath>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/scheme_drift.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<const DistanceJoint*> RodsOf(const World& world, const Subjects& subjects) {
  const auto is_subject = [&](const Anchor& anchor) {
    const std::vector<int>& indices =
        anchor.on == AnchorKind::kBody ? subjects.bodies : subjects.particles;
    return anchor.on != AnchorKind::kWorld &&
           std::find(indices.begin(), indices.end(), anchor.index) != indices.end();
  };
  std::vector<const DistanceJoint*> rods;
  for (const DistanceJoint& joint : world.joints) {
    if (is_subject(joint.A) || is_subject(joint.B)) rods.push_back(&joint);
  }
  return rods;
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  if (RodsOf(world, SubjectsOf(world, claim)).empty())
    faults.push_back({"about", "is held by no rod", "bodies or particles with joints"});
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

CitedName EndOf(const World& world, const Anchor& anchor) {
  switch (anchor.on) {
    case AnchorKind::kBody:
      return {world.bodies[static_cast<std::size_t>(anchor.index)].name};
    case AnchorKind::kParticle:
      return {world.particles[static_cast<std::size_t>(anchor.index)].name};
    case AnchorKind::kWorld:
      break;
  }
  return {.name = "the world", .is_part_of_world = false};
}

/** Returns |ω|² r of an anchor at the distance r from the centre of its body, which turns
 about it. [m/s²] */
double Centripetal(const WorldState& state, const Anchor& anchor) {
  if (anchor.on != AnchorKind::kBody) return 0;
  const BodyState& body = state.bodies[static_cast<std::size_t>(anchor.index)];
  return body.w_WB.squaredNorm() * anchor.point.norm();
}

/** Returns the larger acceleration of the two ends by loads. [m/s²] */
double LargestLoad(const World& world, const DistanceJoint& rod) {
  double largest = world.gravity_W.norm();
  for (const Anchor* end : {&rod.A, &rod.B}) {
    if (end->on != AnchorKind::kBody) continue;
    const RigidBody& body = world.bodies[static_cast<std::size_t>(end->index)];
    if (body.mass > 0) largest = std::max(largest, AccelerationOf(world, body).norm());
  }
  return largest;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  Worst worst(
      MeasureKind::kJointError,
      "1.5 × ½ h ∫ (v²/L + Σ ω² r) dt, for steps along the tangent, 1e-5 of the ends' "
      "motion for the solver, both at speeds that the truth allows, and 64 roundings "
      "per step");
  const AllowedMotion allowed(motion);
  for (const DistanceJoint* rod : RodsOf(world, SubjectsOf(world, claim))) {
    const auto across = [&](const WorldState& state) {
      const PointState A = StateOf(world, state, rod->A);
      const PointState B = StateOf(world, state, rod->B);
      return (B.v_W - A.v_W).norm();
    };
    const std::vector<double> stretched =
        IntegralAlong(allowed, [&](const WorldState& state) {
          // At a sample, the velocity that gravity adds in a step may not be turned along
          // the tangent yet.
          const double v = across(state) + LargestLoad(world, *rod) * world.dt;
          return v * v / (2 * rod->length) +
                 (Centripetal(state, rod->A) + Centripetal(state, rod->B)) / 2;
        });
    const std::vector<double> relative_motion = IntegralAlong(allowed, across);
    double start = 0;
    for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
      const Eigen::Vector3d A = StateOf(world, trajectory.samples[s], rod->A).p_W;
      const Eigen::Vector3d B = StateOf(world, trajectory.samples[s], rod->B).p_W;
      const double length = (B - A).norm();
      if (s == 0) start = std::abs(length - rod->length);
      const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
      worst.Take(
          std::abs(length - rod->length),
          start + kSafety * world.dt * stretched[s] +
              kSolverResidual * relative_motion[s] +
              rounding * (A.norm() + B.norm() + rod->length),
          [&] {
            return Citing(
                "{} has {:.9g} m from {} to {} after {:.6g} s; the rod is {:.9g} m",
                motion.oracle.name, length, EndOf(world, rod->A), EndOf(world, rod->B),
                CitedTime{trajectory.times[s]}, rod->length);
          });
    }
  }
  return FindingsOf({worst});
}

}  // namespace

/** A rod keeps its length: | |p_AB| − L | = 0. [m]

 A step along the tangent lengthens a rod by ½ v² h²/L, where v is the relative velocity
 of its ends across it. An anchor at the distance r from the centre of a body that turns
 at ω adds ½ ω² r h². So an engine that corrects only velocities is off by ½ h ∫ (v²/L +
 Σ ω² r) dt, × 1.5. Added are 1e-5 of the relative motion of the ends for the solver, the
 error of the world at the start, and 64 roundings per step. No speed is larger than the
 truth allows (law_support/allowed_motion.h). An engine whose joints are elastic fails.

 About: bodies and particles, with all rods attached to them. Numbers: none. */
constinit const Law kJointLength = {
    .name = "joint_length",
    .documentation = "A rod keeps its length.",
    .faults = Faults,
    .judge = Judge,
    .universal = [](const World& world) { return ClaimAboutEach(kJointLength, world); },
};

}  // namespace touchstone
