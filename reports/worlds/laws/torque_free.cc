#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/envelope.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/gyroscopic_schemes.h"
#include "reports/worlds/truth/mechanics.h"
#include "reports/worlds/truth/torque_free_rotation.h"

namespace touchstone {
namespace {

Apart Between(const Rotation& a, const Rotation& b) {
  return {a.q_WB.normalized().angularDistance(b.q_WB), (a.w_WB - b.w_WB).norm()};
}

Rotation StartOf(const World& world, int index) {
  const BodyState start = StateAtStart(world).bodies[static_cast<std::size_t>(index)];
  return {start.q_WB, start.w_WB};
}

TorqueFreeRotation TruthOf(const World& world, int index) {
  return {InertiaOf(world.bodies[static_cast<std::size_t>(index)]),
          StartOf(world, index)};
}

/** Returns the largest error so far of any first-order scheme. */
Envelope SchemeErrors(const Motion& motion, int index,
                      const std::vector<Rotation>& truth) {
  const World& world = motion.world;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  Envelope errors(motion);
  for (const GyroscopicScheme scheme : kGyroscopicSchemes) {
    SteppedRotation stepped(scheme, InertiaOf(body), StartOf(world, index), world.dt);
    errors.Include([&] { stepped.Step(); },
                   [&](std::size_t s) { return Between(stepped.state(), truth[s]); });
  }
  return errors;
}

/** Returns how far the truth moves if its spin is rounded as often as the motion is. */
Envelope RoundingErrors(const Motion& motion, int index,
                        const std::vector<Rotation>& truth) {
  const World& world = motion.world;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const double share = RoundingOf(motion.oracle, StepsBefore(motion, truth.size() - 1));
  Envelope errors(motion);
  for (int axis = 0; axis < 3; ++axis) {
    Rotation start = StartOf(world, index);
    start.w_WB += share * start.w_WB.norm() * Eigen::Vector3d::Unit(axis);
    const std::vector<Rotation> rounded =
        TorqueFreeRotation(InertiaOf(body), start).At(motion.trajectory.times);
    errors.Include([] {}, [&](std::size_t s) { return Between(rounded[s], truth[s]); });
  }
  return errors;
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  const Subjects subjects = SubjectsOf(world, claim);
  for (const int i : subjects.bodies) {
    const std::string& name = world.bodies[static_cast<std::size_t>(i)].name;
    if (!IsHeld(world, AnchorKind::kBody, i) && !IsPushed(world, i)) continue;
    faults.push_back(FaultAbout(claim, name, "a spring, a joint or a push may rotate",
                                "a body without torque"));
  }
  if (!faults.empty() || claim.numbers.empty()) return faults;
  if (subjects.bodies.size() > 1) {
    return {{"numbers", "are given for several bodies", "one body if numbers are given"}};
  }
  const TorqueFreeRotation truth = TruthOf(world, subjects.bodies.front());
  return FaultsOfNumbers(claim, {{"expected_rotational_energy", truth.energy()},
                                 {"expected_angular_momentum", truth.angular_momentum()},
                                 {"expected_period", truth.period()}});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  const std::string because =
      "1.5 × the largest error so far of the first-order schemes for the gyroscopic "
      "term, stepped next to the truth, and 64 roundings per step as the truth amplifies "
      "them";
  Worst orientation(MeasureKind::kOrientationError, because);
  Worst spin(MeasureKind::kSpinError, because);
  for (const int i : SubjectsOf(world, claim).bodies) {
    const std::string& name = world.bodies[static_cast<std::size_t>(i)].name;
    const std::vector<Rotation> truth = TruthOf(world, i).At(trajectory.times);
    const Envelope schemes = SchemeErrors(motion, i, truth);
    const Envelope rounding = RoundingErrors(motion, i, truth);
    // The start is that of the world, whatever the law.
    for (std::size_t s = 1; s < trajectory.samples.size(); ++s) {
      const BodyState& is = trajectory.samples[s].bodies[static_cast<std::size_t>(i)];
      const Apart apart = Between({is.q_WB, is.w_WB}, truth[s]);
      const auto tolerance = [&](double scheme, double size, double amplified) {
        return ToleranceOf({.scheme = scheme, .computed = size}, motion.oracle,
                           StepsBefore(motion, s)) +
               amplified;
      };
      orientation.Take(
          apart.place, tolerance(schemes.At(s).place, 1, rounding.At(s).place), [&] {
            return Citing(
                "{} has {} rotated {:.9g} rad from the orientation by Euler's equations "
                "after {:.6g} s",
                motion.oracle.name, CitedName{name}, apart.place,
                CitedTime{trajectory.times[s]});
          });
      spin.Take(
          apart.speed,
          tolerance(schemes.At(s).speed, truth[s].w_WB.norm(), rounding.At(s).speed),
          [&] {
            const ToldApart told = TellApart(is.w_WB, truth[s].w_WB, 9);
            return Citing(
                "{} has {} spinning at {} rad/s after {:.6g} s; Euler's equations say {}",
                motion.oracle.name, CitedName{name}, told.a,
                CitedTime{trajectory.times[s]}, told.b);
          });
    }
  }
  return FindingsOf({orientation, spin});
}

constexpr std::array<std::string_view, 3> kNumbers = {
    "expected_angular_momentum", "expected_period", "expected_rotational_energy"};

}  // namespace

/** A body without torque rotates by Euler's equations, I ω̇ = (I ω) × ω, solved by
 Jacobi's elliptic functions (truth/torque_free_rotation.h). [rad], [rad/s]

 The error of a first-order scheme is computed, not estimated, since a spin near the
 middle axis amplifies any error. The body is stepped by each of the schemes that engines
 use (truth/gyroscopic_schemes.h), and the tolerance is the largest error of any of them
 so far, × 1.5. Rounding is amplified in the same way. Its tolerance is the change of the
 exact rotation if the initial spin changes by 64 roundings per step along each axis.

 About: bodies that no spring, joint, contact or push rotates; any inertia. Measures:
 orientation, spin. Numbers: expected_rotational_energy, expected_angular_momentum,
 expected_period (of ω in the body frame). */
constinit const Law kTorqueFree = {
    .name = "torque_free",
    .documentation =
        "A body without torque rotates by Euler's equations (Jacobi's elliptic "
        "functions).",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .smooth = true,
};

}  // namespace touchstone
