#include "reports/worlds/laws/torque_free.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/gyroscopic_schemes.h"
#include "reports/worlds/truth/mechanics.h"
#include "reports/worlds/truth/torque_free_rotation.h"

namespace touchstone {
namespace {

/** The difference between two rotations. */
struct Apart {
  double angle = 0;  ///< [rad]
  double spin = 0;   ///< [rad/s]

  void TakeLarger(const Apart& other) {
    angle = std::max(angle, other.angle);
    spin = std::max(spin, other.spin);
  }
};

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

/** Returns the largest error of any first-order scheme up to each sample. */
std::vector<Apart> SchemeErrors(const Motion& motion, int index,
                                const std::vector<Rotation>& truth) {
  const World& world = motion.world;
  std::vector<Apart> errors(truth.size());
  for (const GyroscopicScheme scheme : kGyroscopicSchemes) {
    SteppedRotation stepped(scheme,
                            InertiaOf(world.bodies[static_cast<std::size_t>(index)]),
                            StartOf(world, index), world.dt);
    int done = 0;
    for (std::size_t s = 0; s < truth.size(); ++s) {
      const int steps = static_cast<int>(StepsBefore(motion, s));
      for (; done < steps; ++done) stepped.Step();
      errors[s].TakeLarger(Between(stepped.state(), truth[s]));
    }
  }
  for (std::size_t s = 1; s < errors.size(); ++s) errors[s].TakeLarger(errors[s - 1]);
  return errors;
}

/** Returns how far the truth moves if its spin is rounded as often as the motion is. */
std::vector<Apart> RoundingErrors(const Motion& motion, int index,
                                  const std::vector<Rotation>& truth) {
  const World& world = motion.world;
  const double share = RoundingOf(motion.oracle, StepsBefore(motion, truth.size() - 1));
  std::vector<Apart> errors(truth.size());
  for (int axis = 0; axis < 3; ++axis) {
    Rotation start = StartOf(world, index);
    start.w_WB += share * start.w_WB.norm() * Eigen::Vector3d::Unit(axis);
    const TorqueFreeRotation rounded(
        InertiaOf(world.bodies[static_cast<std::size_t>(index)]), start);
    const std::vector<Rotation> at = rounded.At(motion.trajectory.times);
    for (std::size_t s = 0; s < truth.size(); ++s)
      errors[s].TakeLarger(Between(at[s], truth[s]));
  }
  for (std::size_t s = 1; s < errors.size(); ++s) errors[s].TakeLarger(errors[s - 1]);
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
    const std::vector<Apart> schemes = SchemeErrors(motion, i, truth);
    const std::vector<Apart> rounding = RoundingErrors(motion, i, truth);
    // The start is that of the world, whatever the law.
    for (std::size_t s = 1; s < truth.size(); ++s) {
      const BodyState& is = trajectory.samples[s].bodies[static_cast<std::size_t>(i)];
      const Apart apart = Between({is.q_WB, is.w_WB}, truth[s]);
      const double own = RoundingOf(motion.oracle, StepsBefore(motion, s));
      orientation.Take(apart.angle, kSafety * schemes[s].angle + rounding[s].angle + own,
                       [&] {
                         return Citing(
                             "{} has {} rotated {:.9g} rad from the orientation by "
                             "Euler's equations after {:.6g} s",
                             motion.oracle.name, CitedName{name}, apart.angle,
                             CitedTime{trajectory.times[s]});
                       });
      spin.Take(
          apart.spin,
          kSafety * schemes[s].spin + rounding[s].spin + own * truth[s].w_WB.norm(), [&] {
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
