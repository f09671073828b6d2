#include "reports/worlds/law_support/held_by_rods.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/worlds/law_support/envelope.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {
namespace {

/** Relative difference between a rod's length and the distance at the start that counts
 as rounding. [-] */
constexpr double kSameLength = 1e-9;

/** Part of a speed that may be along a rod; velocities have nine digits. [-] */
constexpr double kAlongRod = 1e-9;

/** Returns the rod between `point` and an anchor accepted by `is_other_end`; null if
 there is none or more than one. */
template <typename IsOtherEnd>
const DistanceJoint* RodOf(const World& world, const PointMass& point,
                           const IsOtherEnd& is_other_end) {
  const DistanceJoint* found = nullptr;
  for (const DistanceJoint& joint : world.joints) {
    const bool is_it = (point.IsAt(joint.A) && is_other_end(joint.B)) ||
                       (point.IsAt(joint.B) && is_other_end(joint.A));
    if (!is_it) continue;
    if (found) return nullptr;
    found = &joint;
  }
  return found;
}

const DistanceJoint* RodAbove(const World& world, const std::vector<PointMass>& points,
                              std::size_t i) {
  return RodOf(world, points[i], [&](const Anchor& anchor) {
    return i == 0 ? FixedPointOf(world, anchor).has_value() : points[i - 1].IsAt(anchor);
  });
}

Eigen::Vector3d FixedEndOf(const World& world, const DistanceJoint& rod) {
  const std::optional<Eigen::Vector3d> A = FixedPointOf(world, rod.A);
  return A ? *A : *FixedPointOf(world, rod.B);
}

/** Returns the number of ends of springs and joints at `point`. */
int HoldsOn(const World& world, const PointMass& point) {
  int holds = 0;
  const auto count = [&](const Anchor& anchor) {
    holds += anchor.on == point.on && anchor.index == point.index ? 1 : 0;
  };
  for (const DistanceJoint& joint : world.joints) {
    count(joint.A);
    count(joint.B);
  }
  for (const Spring& spring : world.springs) {
    count(spring.A);
    count(spring.B);
  }
  return holds;
}

/** Returns the centripetal acceleration v²/L at each rod, v the relative velocity of its
 ends. [m/s²] */
std::vector<double> CentripetalAccelerations(const RodSystem& system,
                                             const std::vector<PointState>& state) {
  std::vector<double> accelerations;
  accelerations.reserve(system.rods.size());
  for (const Rod& rod : system.rods) {
    Eigen::Vector3d v_W = state[static_cast<std::size_t>(rod.a)].v_W;
    if (rod.b >= 0) v_W -= state[static_cast<std::size_t>(rod.b)].v_W;
    accelerations.push_back(v_W.squaredNorm() / rod.length);
  }
  return accelerations;
}

}  // namespace

std::vector<PointState> HeldByRods::Start() const {
  std::vector<PointState> start;
  start.reserve(points.size());
  for (const PointMass& point : points) start.push_back(point.start);
  return start;
}

std::string WhyNoChain(const World& world, const std::vector<PointMass>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointMass& point = points[i];
    const DistanceJoint* rod = RodAbove(world, points, i);
    if (!rod) {
      return fmt::format("is {}, which is not joined at its centre by one rod to {}",
                         point.name,
                         i == 0 ? "something fixed" : points[i - 1].name.c_str());
    }
    const bool last = i + 1 == points.size();
    if (HoldsOn(world, point) != (last ? 1 : 2) || point.damping > 0 ||
        (point.on == AnchorKind::kBody && IsPushed(world, point.index)))
      return fmt::format("is {}, which is damped, pushed or held by other links",
                         point.name);
    if (point.a_W != world.gravity_W)
      return fmt::format("is {}, on which a force acts", point.name);
    const Eigen::Vector3d above =
        i == 0 ? FixedEndOf(world, *rod) : points[i - 1].start.p_W;
    if (std::abs((point.start.p_W - above).norm() - rod->length) >
        kSameLength * rod->length)
      return fmt::format("is {}, whose rod does not have its length at the start",
                         point.name);
    const Eigen::Vector3d arm_W = point.start.p_W - above;
    const Eigen::Vector3d& v_W = point.start.v_W;
    const Eigen::Vector3d v_above_W =
        i == 0 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : points[i - 1].start.v_W;
    if (std::abs(arm_W.dot(v_W - v_above_W)) >
        kAlongRod * arm_W.norm() * (v_W.norm() + v_above_W.norm()))
      return fmt::format("is {}, which starts along its rod", point.name);
  }
  return "";
}

HeldByRods ChainOf(const World& world, const std::vector<PointMass>& points) {
  HeldByRods held{points, {{}, {}, world.gravity_W}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DistanceJoint& rod = *RodAbove(world, points, i);
    held.system.mass.push_back(points[i].mass);
    const int point = static_cast<int>(i);
    held.system.rods.push_back(
        i == 0 ? Rod{point, -1, FixedEndOf(world, rod), rod.length}
               : Rod{point, point - 1, Eigen::Vector3d::Zero(), rod.length});
  }
  return held;
}

namespace {

/** Returns the speeds that engines that keep lengths by mean velocities may have along
 the rods at each sample: ¼ h Δ(v²/L) a step, with alternating sign; the largest so far.
 [m/s] */
std::vector<double> SpeedsAlongRods(const Motion& motion, const HeldByRods& held,
                                    const std::vector<std::vector<PointState>>& truth) {
  std::vector<double> largest;
  std::vector<double> last = CentripetalAccelerations(held.system, held.Start());
  std::vector<double> along(last.size(), 0);
  double done = 0;
  double so_far = 0;
  for (std::size_t s = 0; s < truth.size(); ++s) {
    const std::vector<double> now = CentripetalAccelerations(held.system, truth[s]);
    const auto steps = static_cast<int>(std::lround(StepsBefore(motion, s) - done));
    done = StepsBefore(motion, s);
    for (int step = 0; step < steps; ++step) {
      double sum = 0;
      for (std::size_t k = 0; k < now.size(); ++k) {
        along[k] = motion.world.dt / 4 * (now[k] - last[k]) / steps - along[k];
        sum += std::abs(along[k]);
      }
      so_far = std::max(so_far, sum);
    }
    last = now;
    largest.push_back(so_far);
  }
  return largest;
}

Apart Between(const std::vector<PointState>& a, const std::vector<PointState>& b) {
  Apart apart;
  for (std::size_t i = 0; i < a.size(); ++i)
    apart.TakeLarger({(a[i].p_W - b[i].p_W).norm(), (a[i].v_W - b[i].v_W).norm()});
  return apart;
}

}  // namespace

std::vector<LawFinding> JudgeHeld(const Motion& motion, const HeldByRods& held,
                                  const std::vector<std::vector<PointState>>& truth) {
  Envelope errors(motion, truth.size());
  for (const RodScheme scheme : kRodSchemes) {
    std::vector<PointState> stepped = held.Start();
    errors.Include([&] { StepRods(scheme, held.system, motion.world.dt, stepped); },
                   [&](std::size_t s) { return Between(stepped, truth[s]); });
  }
  const std::vector<double> along = SpeedsAlongRods(motion, held, truth);
  std::vector<Prediction> predictions;
  for (std::size_t i = 0; i < held.points.size(); ++i) {
    const PointMass& point = held.points[i];
    predictions.push_back(
        {point.name, point.Reader(), [&, i](std::size_t s) {
           if (s >= truth.size()) return PredictedState{};
           const PointState& is = truth[s][i];
           const double t = motion.trajectory.times[s];
           const double speed = is.v_W.norm() + held.system.g_W.norm() * t;
           return PredictedState{
               .position = {{is.p_W,
                             {.scheme = errors.At(s).place,
                              .computed = is.p_W.norm() + speed * t}}},
               .velocity = {{is.v_W,
                             {.scheme = std::max(errors.At(s).speed, along[s]),
                              .computed = speed}}}};
         }});
  }
  const AllowedWords stepped = {
      .scheme =
          "the largest error so far of first-order engines that constrain rods by "
          "velocity, by Baumgarte's term or by projection, stepped next to the truth; "
          "for "
          "velocities at least ¼ h Δ(v²/L) a step along each rod, as of engines that "
          "keep "
          "lengths by mean velocities"};
  return FindingsOf(JudgePredictions(motion,
                                     {.position = {stepped, "the exact swing is at"},
                                      .velocity = {stepped, "the exact swing moves at"}},
                                     predictions));
}

}  // namespace touchstone
