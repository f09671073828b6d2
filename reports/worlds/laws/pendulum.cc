#include "reports/worlds/truth/pendulum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/held_by_rods.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"

namespace touchstone {
namespace {

/** Part of a speed that may be across the plane of the swing. [-] */
constexpr double kInPlane = 1e-9;

/** Smallest 1 + cos θ at which a mass at rest does not count as balanced above its pivot.
 [-] */
constexpr double kOnHead = 1e-6;

/** Name of the number that ends the judgement. */
constexpr std::string_view kUntil = "until";

/** A pendulum at p + L (sin θ x̂ + cos θ ĝ). */
struct Swinging {
  Eigen::Vector3d p_W;
  Eigen::Vector3d x_W;
  Eigen::Vector3d down_W;
  double length;
  double omega;
  PendulumAngle start;
};

Swinging SwingingOf(const World& world, const std::vector<PointMass>& points) {
  Swinging swinging;
  const Rod rod = ChainOf(world, points).system.rods.front();
  const PointState& start = points.front().start;
  const Eigen::Vector3d arm_W = start.p_W - rod.p_W;
  swinging.p_W = rod.p_W;
  swinging.length = arm_W.norm();
  swinging.down_W = world.gravity_W.normalized();
  swinging.omega = std::sqrt(world.gravity_W.norm() / swinging.length);
  const auto across = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(v - v.dot(swinging.down_W) * swinging.down_W);
  };
  // If it hangs straight down, its velocity determines the plane.
  const Eigen::Vector3d side_W = across(arm_W);
  swinging.x_W = side_W.norm() > kInPlane * swinging.length
                     ? side_W.normalized()
                     : across(start.v_W).normalized();
  const double sine = arm_W.dot(swinging.x_W);
  const double cosine = arm_W.dot(swinging.down_W);
  const Eigen::Vector3d tangent_W =
      (cosine * swinging.x_W - sine * swinging.down_W) / swinging.length;
  swinging.start = {std::atan2(sine, cosine), start.v_W.dot(tangent_W) / swinging.length};
  return swinging;
}

/** Returns the reason why a single mass does not swing in a vertical plane. */
std::string WhyNoPlaneSwing(const World& world, const std::vector<PointMass>& points) {
  if (world.gravity_W.isZero(0)) return "is in a world without gravity";
  const Swinging swinging = SwingingOf(world, points);
  const Eigen::Vector3d& v_W = points.front().start.v_W;
  const Eigen::Vector3d across_W = swinging.x_W.cross(swinging.down_W);
  if (std::abs(v_W.dot(across_W)) > kInPlane * v_W.norm())
    return "does not start along a circle in a vertical plane";
  if (1 + std::cos(swinging.start.theta) < kOnHead && v_W.isZero(0))
    return "is balanced above its pivot";
  return "";
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  const std::vector<PointMass> points = PointMassesInOrder(world, claim);
  const bool one = points.size() == 1;
  std::string why = WhyNoChain(world, points);
  if (why.empty() && one) why = WhyNoPlaneSwing(world, points);
  if (!why.empty()) {
    return {
        {"about", why,
         one ? "a mass on one rod to a fixed point, swinging in a plane"
             : "first a mass on a rod to a fixed point, then each on a rod to the one "
               "before"}};
  }
  if (NumberOr(claim, kUntil, HUGE_VAL) < SampleSpacing(world)) {
    return {{"numbers.until", "is before the first sample after the start",
             fmt::format("at least {:g} s", SampleSpacing(world))}};
  }
  if (!one) return FaultsOfNumbers(claim, {});
  const Swinging swinging = SwingingOf(world, points);
  return FaultsOfNumbers(
      claim, {{"expected_period", Pendulum(swinging.omega, swinging.start).period()}});
}

/** Returns the state of the mass at an angle of its swing. */
PointState At(const Swinging& swinging, const PendulumAngle& angle) {
  const double sine = std::sin(angle.theta);
  const double cosine = std::cos(angle.theta);
  const Eigen::Vector3d& x_W = swinging.x_W;
  const Eigen::Vector3d& down_W = swinging.down_W;
  return {swinging.p_W + swinging.length * (sine * x_W + cosine * down_W),
          swinging.length * angle.rate * (cosine * x_W - sine * down_W)};
}

/** Returns the exact motion at each of `times` until the time that the claim states. */
std::vector<std::vector<PointState>> TruthOf(const World& world, const Claim& claim,
                                             const HeldByRods& held,
                                             const std::vector<double>& times) {
  const double until = NumberOr(claim, kUntil, HUGE_VAL);
  std::vector<std::vector<PointState>> truth;
  const auto end =
      std::find_if(times.begin(), times.end(), [&](double t) { return t > until; });
  if (held.points.size() == 1) {
    const Swinging swinging = SwingingOf(world, held.points);
    const Pendulum pendulum(swinging.omega, swinging.start);
    for (auto t = times.begin(); t != end; ++t)
      truth.push_back({At(swinging, pendulum.At(*t))});
    return truth;
  }
  std::vector<PointState> state = held.Start();
  double reached = 0;
  for (auto t = times.begin(); t != end; ++t) {
    state = held.system.After(state, *t - std::exchange(reached, *t));
    truth.push_back(state);
  }
  return truth;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const HeldByRods held = ChainOf(motion.world, PointMassesInOrder(motion.world, claim));
  // The samples end early if the motion diverged.
  const std::vector<double> times(
      motion.trajectory.times.begin(),
      motion.trajectory.times.begin() +
          static_cast<std::ptrdiff_t>(motion.trajectory.samples.size()));
  return JudgeHeld(motion, held, TruthOf(motion.world, claim, held, times));
}

std::vector<Eigen::Vector3d> Places(const World& world, const Claim& claim,
                                    const std::vector<double>& times) {
  const HeldByRods held = ChainOf(world, PointMassesInOrder(world, claim));
  const std::string first = PointMassesOf(world, SubjectsOf(world, claim)).front().name;
  const auto i = static_cast<std::size_t>(
      std::ranges::find(held.points, first, &PointMass::name) - held.points.begin());
  std::vector<Eigen::Vector3d> places;
  for (const std::vector<PointState>& truth : TruthOf(world, claim, held, times))
    places.push_back(truth[i].p_W);
  return places;
}

constexpr std::array<std::string_view, 1> kAliases = {"double_pendulum"};
constexpr std::array<std::string_view, 2> kNumbers = {"expected_period", kUntil};

}  // namespace

/** A point on a rod to a fixed point swings in a plane, by elliptic functions
 (truth/pendulum.h). Its period from rest at θ₀ is 4 √(L/g) K(sin² ½θ₀) (IFToMM benchmark
 A01). Points on a chain of rods have no closed form; their motion is integrated
 (truth/rods.h) until their chaos amplifies the error of an engine. [m], [m/s]

 A rod that is constrained by velocities loses the power ½ m v⁴ h/L², or becomes longer.
 An engine in angles has δT/T = −h² g cos θ₀/(24 L). The tolerance is that of
 law_support/held_by_rods.h.

 About: one body, held at its centre, or one particle, moving in a vertical plane; or
 several, from the fixed point outwards. Numbers: expected_period, of a swing or of one
 full turn; until: judged up to then [s]. */
constinit const Law kPendulum = {
    .name = "pendulum",
    .aliases = kAliases,
    .documentation =
        "A mass on one rod to a fixed point swings in a plane; or several swing on a "
        "chain of rods, and about names them from the fixed point outwards.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .smooth = true,
    .places = Places,
};

}  // namespace touchstone
