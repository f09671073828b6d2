#include "reports/worlds/truth/net_motion.h"

#include <algorithm>
#include <cmath>

namespace touchstone {
namespace {

/** Most evaluations of a link: about a second of work. */
constexpr double kMostLooks = 1e8;

/** Distance of minima that count as equal, over their size. [-] */
constexpr double kSamePlace = 1e-6;

/** Positions and velocities of a net's points, or their rates. */
struct Phase {
  Net::Points p_W;
  Net::Points v_W;

  Phase Plus(double h, const Phase& rate) const {
    Phase sum = *this;
    for (std::size_t i = 0; i < p_W.size(); ++i) {
      sum.p_W[i] += h * rate.p_W[i];
      sum.v_W[i] += h * rate.v_W[i];
    }
    return sum;
  }
};

Phase RateOf(const Net& net, std::span<const double> drag, const Phase& at) {
  Phase rate{at.v_W, Net::Points(at.v_W.size(), net.g_W)};
  for (const Net::Link& link : net.links) {
    const auto a = static_cast<std::size_t>(link.a);
    const auto b = static_cast<std::size_t>(link.b);
    const Eigen::Vector3d arm_W = at.p_W[b] - at.p_W[a];
    const double length = arm_W.norm();
    const Eigen::Vector3d d_W = arm_W / length;
    const double pull = link.stiffness * (length - link.rest_length) +
                        link.damping * d_W.dot(at.v_W[b] - at.v_W[a]);
    if (net.mass[a] > 0) rate.v_W[a] += pull / net.mass[a] * d_W;
    if (net.mass[b] > 0) rate.v_W[b] -= pull / net.mass[b] * d_W;
  }
  for (std::size_t i = 0; i < rate.v_W.size(); ++i) {
    if (net.mass[i] > 0)
      rate.v_W[i] -= drag[i] * at.v_W[i];
    else
      rate.p_W[i] = rate.v_W[i] = Eigen::Vector3d::Zero();
  }
  return rate;
}

/** Returns an upper bound of the rate at which anything oscillates or decays: by
 Gershgorin's circles, a link counts twice its stiffness at either end. [1/s] */
double FastestRate(const Net& net, std::span<const double> drag) {
  std::vector<double> stiffness(net.mass.size());
  std::vector<double> damping(net.mass.size());
  for (const Net::Link& link : net.links) {
    for (const int end : {link.a, link.b}) {
      stiffness[static_cast<std::size_t>(end)] += 2 * link.stiffness;
      damping[static_cast<std::size_t>(end)] += 2 * link.damping;
    }
  }
  double fastest = 0;
  for (std::size_t i = 0; i < net.mass.size(); ++i) {
    if (net.mass[i] == 0) continue;
    const double swing = std::sqrt(stiffness[i] / net.mass[i]);
    fastest = std::max(fastest, swing + damping[i] / net.mass[i] + drag[i]);
  }
  return fastest;
}

Net::Points Moved(const Net& net, std::span<const double> drag, Phase at, double duration,
                  int steps) {
  const double h = duration / steps;
  for (int step = 0; step < steps; ++step) {
    const Phase k1 = RateOf(net, drag, at);
    const Phase k2 = RateOf(net, drag, at.Plus(h / 2, k1));
    const Phase k3 = RateOf(net, drag, at.Plus(h / 2, k2));
    const Phase k4 = RateOf(net, drag, at.Plus(h, k3));
    at = at.Plus(h / 6, k1).Plus(h / 3, k2).Plus(h / 3, k3).Plus(h / 6, k4);
  }
  return at.p_W;
}

}  // namespace

std::optional<Net::Points> RestAfter(const Net& net, std::span<const double> drag,
                                     const Net::Points& points_W,
                                     const Net::Points& velocities_W, double duration) {
  const double steps = std::ceil(4 * duration * FastestRate(net, drag));
  if (!(12 * steps * static_cast<double>(net.links.size()) < kMostLooks)) return {};
  const auto rest = [&](int count) {
    return net.Minimum(Moved(net, drag, {points_W, velocities_W}, duration, count));
  };
  const Net::Points rest_W = rest(static_cast<int>(steps));
  const Net::Points finer_W = rest(2 * static_cast<int>(steps));
  for (std::size_t i = 0; i < rest_W.size(); ++i) {
    // Written so that a NaN yields no minimum.
    if (!((finer_W[i] - rest_W[i]).norm() <= kSamePlace * (1 + rest_W[i].norm())))
      return {};
  }
  return finer_W;
}

}  // namespace touchstone
