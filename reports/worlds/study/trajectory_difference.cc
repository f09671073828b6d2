#include "reports/worlds/study/trajectory_difference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "reports/worlds/study/world_size.h"

namespace touchstone {
namespace {

// A NaN counts as the largest value and is never replaced.
void TakeLarger(double& largest, double value) {
  if (!std::isnan(largest) && !(value <= largest)) largest = value;
}

double PointDistance(const std::vector<PointState>& a, const std::vector<PointState>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    TakeLarger(largest, (a[i].p_W - b[i].p_W).norm());
  return largest;
}

/** The numbers of a state as one flat list, with the names of each. */
struct Numbers {
  std::vector<double> values;
  std::vector<std::string> things;  ///< The body, particle or node that it is of.
  std::vector<std::string> fields;  ///< E.g. "velocity.y".

  void Add(const std::string& thing, std::string field, double value) {
    values.push_back(value);
    things.push_back(thing);
    fields.push_back(std::move(field));
  }

  void Add(const std::string& thing, std::string_view field, const Eigen::Vector3d& v) {
    for (int axis = 0; axis < 3; ++axis)
      Add(thing, fmt::format("{}.{}", field, "xyz"[axis]), v[axis]);
  }

  void Add(const std::string& thing, const PointState& point) {
    Add(thing, "position", point.p_W);
    Add(thing, "velocity", point.v_W);
  }
};

Numbers NumbersOf(const World& world, const WorldState& state) {
  Numbers numbers;
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    const BodyState& body = state.bodies[i];
    const std::string& name = world.bodies[i].name;
    numbers.Add(name, "position", body.p_WB);
    numbers.Add(name, "orientation.w", body.q_WB.w());
    numbers.Add(name, "orientation", body.q_WB.vec());
    numbers.Add(name, "velocity", body.v_WB);
    numbers.Add(name, "spin", body.w_WB);
  }
  for (std::size_t i = 0; i < state.particles.size(); ++i)
    numbers.Add(world.particles[i].name, state.particles[i]);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    numbers.Add(fmt::format("node {}", i), state.nodes[i]);
  return numbers;
}

bool HaveSameParts(const WorldState& a, const WorldState& b) {
  return a.bodies.size() == b.bodies.size() && a.particles.size() == b.particles.size() &&
         a.nodes.size() == b.nodes.size();
}

bool AreSame(double a, double b) {
  return a == b || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool IsSameBody(const BodyState& a, const BodyState& b) {
  return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs() && a.v_WB == b.v_WB &&
         a.w_WB == b.w_WB;
}

bool IsSamePoint(const PointState& a, const PointState& b) {
  return a.p_W == b.p_W && a.v_W == b.v_W;
}

PointState Extrapolated(const PointState& coarse, const PointState& fine) {
  return {2 * fine.p_W - coarse.p_W, 2 * fine.v_W - coarse.v_W};
}

BodyState Extrapolated(const BodyState& coarse, const BodyState& fine) {
  // q and −q are one orientation.
  const double sign = coarse.q_WB.dot(fine.q_WB) < 0 ? -1 : 1;
  const Eigen::Vector4d q = 2 * fine.q_WB.coeffs() - sign * coarse.q_WB.coeffs();
  return {2 * fine.p_WB - coarse.p_WB, Eigen::Quaterniond(q.normalized()),
          2 * fine.v_WB - coarse.v_WB, 2 * fine.w_WB - coarse.w_WB};
}

template <typename State>
std::vector<State> Extrapolated(const std::vector<State>& coarse,
                                const std::vector<State>& fine) {
  std::vector<State> limit;
  limit.reserve(fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i)
    limit.push_back(Extrapolated(coarse[i], fine[i]));
  return limit;
}

}  // namespace

std::vector<double> DistancesBetween(const Trajectory& a, const Trajectory& b,
                                     double radius, double until) {
  std::vector<double> distances;
  const std::size_t samples = std::min(a.samples.size(), b.samples.size());
  for (std::size_t s = 0; s < samples && a.times[s] < until; ++s) {
    const WorldState& of_a = a.samples[s];
    const WorldState& of_b = b.samples[s];
    double largest = 0;
    for (std::size_t i = 0; i < of_a.bodies.size(); ++i) {
      const BodyState& body_a = of_a.bodies[i];
      const BodyState& body_b = of_b.bodies[i];
      TakeLarger(largest, (body_a.p_WB - body_b.p_WB).norm() +
                              radius * body_a.q_WB.angularDistance(body_b.q_WB));
    }
    TakeLarger(largest, PointDistance(of_a.particles, of_b.particles));
    TakeLarger(largest, PointDistance(of_a.nodes, of_b.nodes));
    distances.push_back(largest);
  }
  return distances;
}

double DistanceBetween(const Trajectory& a, const Trajectory& b, double radius,
                       double until) {
  double largest = 0;
  for (const double distance : DistancesBetween(a, b, radius, until))
    TakeLarger(largest, distance);
  return largest;
}

Proof LargestDifference(const World& world, const Trajectory& a, const Trajectory& b,
                        double until) {
  const double radius = LargestRadius(world);
  const std::vector<double> distances = DistancesBetween(a, b, radius, until);
  const auto largest = std::max_element(distances.begin(), distances.end());
  if (largest == distances.end() || !(*largest > 0)) return {};
  const auto s = static_cast<std::size_t>(largest - distances.begin());
  const WorldState& of_a = a.samples[s];
  const WorldState& of_b = b.samples[s];
  Proof places{.kind = ProofKind::kPlaces, .time = a.times[s]};
  double farthest = 0;
  const auto take = [&](std::string name, const Eigen::Vector3d& p,
                        const Eigen::Vector3d& q, double angle) {
    const double distance = (p - q).norm() + radius * angle;
    if (distance <= farthest) return;
    farthest = distance;
    places.rest = angle;
    places.points_W = {p, q};
    places.body = std::move(name);
  };
  for (std::size_t i = 0; i < of_a.bodies.size(); ++i) {
    take(world.bodies[i].name, of_a.bodies[i].p_WB, of_b.bodies[i].p_WB,
         of_a.bodies[i].q_WB.angularDistance(of_b.bodies[i].q_WB));
  }
  for (std::size_t i = 0; i < of_a.particles.size(); ++i)
    take(world.particles[i].name, of_a.particles[i].p_W, of_b.particles[i].p_W, 0);
  for (std::size_t i = 0; i < of_a.nodes.size(); ++i)
    take(fmt::format("node {}", i), of_a.nodes[i].p_W, of_b.nodes[i].p_W, 0);
  return places.points_W.empty() ? Proof{} : places;
}

bool AreEqual(const WorldState& a, const WorldState& b) {
  return std::ranges::equal(a.bodies, b.bodies, IsSameBody) &&
         std::ranges::equal(a.particles, b.particles, IsSamePoint) &&
         std::ranges::equal(a.nodes, b.nodes, IsSamePoint);
}

CitingProof FirstDifference(const World& world, const Trajectory& a,
                            const Trajectory& b) {
  const std::size_t samples = std::min(a.samples.size(), b.samples.size());
  for (std::size_t s = 0; s < samples; ++s) {
    if (AreEqual(a.samples[s], b.samples[s])) continue;
    const CitedTime time{a.times[s]};
    if (!HaveSameParts(a.samples[s], b.samples[s]))
      return Citing("at {:.6g} s the numbers of bodies or points differ", time);
    const Numbers of_a = NumbersOf(world, a.samples[s]);
    const Numbers of_b = NumbersOf(world, b.samples[s]);
    for (std::size_t i = 0; i < of_a.values.size(); ++i) {
      if (AreSame(of_a.values[i], of_b.values[i])) continue;
      return Citing("at {:.6g} s {} {} is {:.17g} and {:.17g}", time,
                    CitedName{of_a.things[i]}, of_a.fields[i], of_a.values[i],
                    of_b.values[i]);
    }
  }
  if (a.samples.size() == b.samples.size()) return {};
  const Trajectory& longer = a.samples.size() < b.samples.size() ? b : a;
  return Citing("at {:.6g} s one ends and the other goes on",
                CitedTime{longer.times[samples]});
}

Trajectory ExtrapolatedToZeroStep(const Trajectory& coarse, const Trajectory& fine) {
  Trajectory limit;
  limit.status = AnswerStatus::kAnswered;
  limit.times = fine.times;
  for (std::size_t s = 0; s < fine.samples.size(); ++s) {
    const WorldState& c = coarse.samples[s];
    const WorldState& f = fine.samples[s];
    limit.samples.push_back({Extrapolated(c.bodies, f.bodies),
                             Extrapolated(c.particles, f.particles),
                             Extrapolated(c.nodes, f.nodes)});
  }
  return limit;
}

}  // namespace touchstone
