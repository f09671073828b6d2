#include "reports/worlds/laws/never_penetrates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/slop.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (NumberOr(claim, "slack", 0) < 0)
    faults.push_back({"numbers.slack", "is negative", "a length >= 0"});
  const double parted_by = NumberOr(claim, "parted_by", 0);
  if (parted_by < 0 || parted_by >= world.steps * world.dt)
    faults.push_back({"numbers.parted_by", fmt::format("is {:.6g} s", parted_by),
                      "a time before the end"});
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

bool Collides(const World& world, int A, int B) {
  const RigidBody& body_A = world.bodies[static_cast<std::size_t>(A)];
  const RigidBody& body_B = world.bodies[static_cast<std::size_t>(B)];
  return A != B && body_A.collides && body_B.collides &&
         !(std::holds_alternative<HalfSpace>(body_A.placed.shape) &&
           std::holds_alternative<HalfSpace>(body_B.placed.shape));
}

/** Returns how fast the surface of a body may move by its rotation. [m/s] */
double SurfaceSpeed(const RigidBody& body, const BodyState& at) {
  if (std::holds_alternative<Sphere>(body.placed.shape)) return 0;
  return at.w_WB.norm() * BoundingRadius(body.placed.shape);
}

/** Returns how fast two bodies may come to approach each other before the next sample;
 not their relative speed, since an impact may stop one of two bodies that fly together.
 The speeds count along the normal if every step is sampled and the shapes alone determine
 it, as for spheres and half-spaces; otherwise in full. [m/s] */
double CentreSpeeds(const World& world, const WorldState& state, std::size_t a,
                    std::size_t b) {
  const Eigen::Vector3d& v_A_W = state.bodies[a].v_WB;
  const Eigen::Vector3d& v_B_W = state.bodies[b].v_WB;
  const Shape& A = world.bodies[a].placed.shape;
  const Shape& B = world.bodies[b].placed.shape;
  Eigen::Vector3d n_W = state.bodies[b].p_WB - state.bodies[a].p_WB;
  if (std::holds_alternative<HalfSpace>(A)) {
    n_W = world.bodies[a].placed.X_WB.R_WB.col(2);
  } else if (std::holds_alternative<HalfSpace>(B)) {
    n_W = world.bodies[b].placed.X_WB.R_WB.col(2);
  } else if (!std::holds_alternative<Sphere>(A) || !std::holds_alternative<Sphere>(B)) {
    return v_A_W.norm() + v_B_W.norm();
  }
  if (world.sample_every > 1) return v_A_W.norm() + v_B_W.norm();
  n_W.normalize();
  return std::abs(v_A_W.dot(n_W)) + std::abs(v_B_W.dot(n_W));
}

double ApproachSpeed(const World& world, const WorldState& state, int A, int B) {
  const auto a = static_cast<std::size_t>(A);
  const auto b = static_cast<std::size_t>(B);
  return CentreSpeeds(world, state, a, b) +
         SurfaceSpeed(world.bodies[a], state.bodies[a]) +
         SurfaceSpeed(world.bodies[b], state.bodies[b]);
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  const Subjects subjects = SubjectsOf(world, claim);
  const double slack = NumberOr(claim, "slack", 0) + motion.oracle.slop;
  // It is unknown how soon, if ever, an engine separates what overlaps at the start.
  const double parted_by =
      NumberOr(claim, "parted_by", std::numeric_limits<double>::infinity());
  const double g = world.gravity_W.norm();
  Worst worst(
      MeasureKind::kPenetration,
      fmt::format("1.5 × (V h + g h²), V the largest sum of both speeds since "
                  "they were apart, or so far if not every step is sampled{}",
                  NumberOr(claim, "slack", 0) > 0
                      ? WithSlop(", and the slack that the claim grants", motion.oracle)
                      : WithSlop("", motion.oracle)));
  const WorldState start = StateAtStart(world);
  const auto hold = [&](int A, int B) {
    const double at_start = OverlapOf(world, start, A, B);
    double V = ApproachSpeed(world, start, A, B);
    for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
      const WorldState& state = trajectory.samples[s];
      const double now = ApproachSpeed(world, state, A, B);
      const double depth = OverlapOf(world, state, A, B);
      V = std::max(V, now);
      const double granted =
          trajectory.times[s] < parted_by - world.dt / 2 ? at_start : 0;
      const double between = V + g * SampleSpacing(world);
      const double reach = state.bodies[static_cast<std::size_t>(A)].p_WB.norm() +
                           state.bodies[static_cast<std::size_t>(B)].p_WB.norm();
      worst.Take(depth,
                 kSafety * (between * world.dt + g * world.dt * world.dt) + granted +
                     slack + RoundingOf(motion.oracle, StepsBefore(motion, s)) * reach,
                 [&] {
                   return fmt::format(
                       "{} has {} {:.6g} m deep in {} after {:.6g} s; the sum of their "
                       "speeds was {:.6g} m/s at most",
                       motion.oracle.name, world.bodies[static_cast<std::size_t>(A)].name,
                       depth, world.bodies[static_cast<std::size_t>(B)].name,
                       trajectory.times[s], V);
                 });
      if (depth == 0 && world.sample_every == 1) V = now;
    }
  };
  const auto is_subject = [&](int index) {
    return std::find(subjects.bodies.begin(), subjects.bodies.end(), index) !=
           subjects.bodies.end();
  };
  const int bodies = static_cast<int>(world.bodies.size());
  for (const int A : subjects.bodies) {
    for (int B = 0; B < bodies; ++B) {
      // A pair of two subjects is judged once.
      if (Collides(world, A, B) && !(is_subject(B) && B < A)) hold(A, B);
    }
  }
  return FindingsOf({worst});
}

constexpr std::array<std::string_view, 2> kNumbers = {"parted_by", "slack"};

}  // namespace

constinit const Law kNeverPenetrates = {
    .name = "never_penetrates",
    .documentation =
        "Colliding bodies penetrate by at most V h + g h²; slack [m] is granted on top, "
        "and "
        "until parted_by [s] also the overlap at the start.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
