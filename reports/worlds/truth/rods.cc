#include "reports/worlds/truth/rods.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace touchstone {
namespace {

/** Fraction of a rod's error that Baumgarte's term removes in a step: the default of
 engines. [-] */
constexpr double kBaumgarteShare = 0.2;

/** The number of times that a step may be halved. A mass that is 10^-4 of the one below
 snaps through at up to 10^2 times the speed of the latter. [-] */
constexpr int kMostHalvings = 12;

/** Columns of the extrapolation; the order is twice that. */
constexpr int kColumns = 8;

/** The vector from a rod's end a to its end b, and its rate. */
struct Lying {
  Eigen::Vector3d d_W;
  Eigen::Vector3d v_W;
};

Lying LyingOf(const Rod& rod, const std::vector<PointState>& state) {
  const PointState& a = state[static_cast<std::size_t>(rod.a)];
  if (rod.b < 0) return {rod.p_W - a.p_W, -a.v_W};
  const PointState& b = state[static_cast<std::size_t>(rod.b)];
  return {b.p_W - a.p_W, b.v_W - a.v_W};
}

/** Returns J M⁻¹ Jᵀ for rods with the vectors `d`. */
Eigen::MatrixXd Responses(const RodSystem& system,
                          const std::vector<Eigen::Vector3d>& d) {
  const std::size_t n = system.rods.size();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(static_cast<int>(n), static_cast<int>(n));
  const auto sign = [](const Rod& rod, int point) {
    return rod.b == point ? 1.0 : rod.a == point ? -1.0 : 0.0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < system.mass.size(); ++k) {
        const int point = static_cast<int>(k);
        K(static_cast<int>(i), static_cast<int>(j)) += sign(system.rods[i], point) *
                                                       sign(system.rods[j], point) *
                                                       d[i].dot(d[j]) / system.mass[k];
      }
    }
  }
  return K;
}

/** Returns the velocity change of each point by the impulses `lambda` along the rods
 `d`. */
std::vector<Eigen::Vector3d> Kicks(const RodSystem& system,
                                   const std::vector<Eigen::Vector3d>& d,
                                   const Eigen::VectorXd& lambda) {
  std::vector<Eigen::Vector3d> kicks(system.mass.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < system.rods.size(); ++i) {
    const Rod& rod = system.rods[i];
    const Eigen::Vector3d J = lambda[static_cast<int>(i)] * d[i];
    const auto a = static_cast<std::size_t>(rod.a);
    kicks[a] -= J / system.mass[a];
    if (rod.b < 0) continue;
    const auto b = static_cast<std::size_t>(rod.b);
    kicks[b] += J / system.mass[b];
  }
  return kicks;
}

using Rates = std::vector<PointState>;

Rates RatesOf(const RodSystem& system, const std::vector<PointState>& state) {
  const std::vector<Eigen::Vector3d> a = system.Accelerations(state);
  Rates rates;
  rates.reserve(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) rates.push_back({state[i].v_W, a[i]});
  return rates;
}

void Add(double factor, const Rates& rates, std::vector<PointState>& state) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].p_W += factor * rates[i].p_W;
    state[i].v_W += factor * rates[i].v_W;
  }
}

/** Gragg's modified midpoint method over `H` in `n` (even) parts. */
std::vector<PointState> Midpoint(const RodSystem& system,
                                 const std::vector<PointState>& start, double H, int n) {
  const double h = H / n;
  std::vector<PointState> before = start;
  std::vector<PointState> now = start;
  Add(h, RatesOf(system, start), now);
  for (int i = 1; i < n; ++i) {
    std::vector<PointState> next = before;
    Add(2 * h, RatesOf(system, now), next);
    before = std::move(now);
    now = std::move(next);
  }
  // Smoothed: ½ (x_n + x_{n−1} + h f(x_n)).
  std::vector<PointState> end = before;
  Add(h, RatesOf(system, now), end);
  for (std::size_t i = 0; i < end.size(); ++i) {
    end[i].p_W = (end[i].p_W + now[i].p_W) / 2;
    end[i].v_W = (end[i].v_W + now[i].v_W) / 2;
  }
  return end;
}

/** The state after a step. */
struct Extrapolation {
  std::vector<PointState> state;  ///< Of order 2 kColumns.
  /** The largest difference from that of order 2 kColumns − 2, relative to the size of
   the system, or to its speed. [-] */
  double error;
};

/** Returns the largest difference of two states, relative to the largest distance from
 `origin_W` and the largest speed of the first. */
double DifferenceOf(const std::vector<PointState>& state,
                    const std::vector<PointState>& other,
                    const Eigen::Vector3d& origin_W) {
  double size = 0;
  double speed = 0;
  double moved = 0;
  double changed = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    size = std::max(size, (state[i].p_W - origin_W).norm());
    speed = std::max(speed, state[i].v_W.norm());
    moved = std::max(moved, (state[i].p_W - other[i].p_W).norm());
    changed = std::max(changed, (state[i].v_W - other[i].v_W).norm());
  }
  return std::max(moved / size, speed > 0 ? changed / speed : 0);
}

Extrapolation Extrapolated(const RodSystem& system, const std::vector<PointState>& start,
                           double H) {
  // Aitken-Neville extrapolation in h², for 2, 4, 6, … parts.
  std::vector<std::vector<PointState>> row;
  for (int k = 0; k < kColumns; ++k) {
    std::vector<PointState> next = Midpoint(system, start, H, 2 * (k + 1));
    for (int j = 0; j < k; ++j) {
      const double ratio = static_cast<double>(k + 1) / (k - j);
      const double share = 1 / (ratio * ratio - 1);
      std::vector<PointState> better = next;
      std::vector<PointState>& coarse = row[static_cast<std::size_t>(j)];
      for (std::size_t i = 0; i < next.size(); ++i) {
        better[i].p_W += share * (next[i].p_W - coarse[i].p_W);
        better[i].v_W += share * (next[i].v_W - coarse[i].v_W);
      }
      coarse = std::move(next);
      next = std::move(better);
    }
    row.push_back(std::move(next));
  }
  const Eigen::Vector3d& origin_W = system.rods.front().p_W;
  return {row.back(), DifferenceOf(row.back(), row[kColumns - 2], origin_W)};
}

/** Returns the motion after `H`, which is halved at most `halvings` times. */
std::vector<PointState> Advanced(const RodSystem& system,
                                 const std::vector<PointState>& start, double H,
                                 int halvings) {
  constexpr double kTolerance = 1e-12;
  Extrapolation step = Extrapolated(system, start, H);
  // Written so that a NaN is halved.
  if (halvings == 0 || step.error <= kTolerance) return std::move(step.state);
  return Advanced(system, Advanced(system, start, H / 2, halvings - 1), H / 2,
                  halvings - 1);
}

}  // namespace

std::vector<Eigen::Vector3d> RodSystem::Accelerations(
    const std::vector<PointState>& state) const {
  std::vector<Eigen::Vector3d> d;
  Eigen::VectorXd b(static_cast<int>(rods.size()));
  for (std::size_t i = 0; i < rods.size(); ++i) {
    const Lying lying = LyingOf(rods[i], state);
    d.push_back(lying.d_W);
    // Gravity accelerates both ends alike, except a fixed end.
    const double falling = rods[i].b < 0 ? lying.d_W.dot(-g_W) : 0;
    b[static_cast<int>(i)] = -lying.v_W.squaredNorm() - falling;
  }
  std::vector<Eigen::Vector3d> a = Kicks(*this, d, Responses(*this, d).ldlt().solve(b));
  for (Eigen::Vector3d& point : a) point += g_W;
  return a;
}

std::vector<PointState> RodSystem::After(const std::vector<PointState>& start,
                                         double t) const {
  double shortest = rods.front().length;
  for (const Rod& rod : rods) shortest = std::min(shortest, rod.length);
  double speed = std::sqrt(g_W.norm() * shortest);
  for (const PointState& point : start) speed = std::max(speed, point.v_W.norm());
  const double steps = std::ceil(t * 50 * speed / shortest);
  std::vector<PointState> state = start;
  for (double done = 0; done < steps; ++done)
    state = Advanced(*this, state, t / steps, kMostHalvings);
  return state;
}

void StepRods(RodScheme scheme, const RodSystem& system, double h,
              std::vector<PointState>& state) {
  for (PointState& point : state) point.v_W += h * system.g_W;
  std::vector<Eigen::Vector3d> d;
  Eigen::VectorXd target(static_cast<int>(system.rods.size()));
  for (std::size_t i = 0; i < system.rods.size(); ++i) {
    const Lying lying = LyingOf(system.rods[i], state);
    d.push_back(lying.d_W);
    const double too_long = lying.d_W.norm() - system.rods[i].length;
    const double back =
        scheme == RodScheme::kBaumgarte ? kBaumgarteShare * too_long / h : 0;
    target[static_cast<int>(i)] = -lying.d_W.dot(lying.v_W) - back * lying.d_W.norm();
  }
  const Eigen::LDLT<Eigen::MatrixXd> responses(Responses(system, d));
  const std::vector<Eigen::Vector3d> kicks = Kicks(system, d, responses.solve(target));
  for (std::size_t i = 0; i < state.size(); ++i) {
    state[i].v_W += kicks[i];
    state[i].p_W += h * state[i].v_W;
  }
  if (scheme != RodScheme::kProjected) return;
  // Newton's method along the current rods; each pass squares the error.
  for (int pass = 0; pass < 8; ++pass) {
    for (std::size_t i = 0; i < system.rods.size(); ++i) {
      const double length = system.rods[i].length;
      const Lying lying = LyingOf(system.rods[i], state);
      d[i] = lying.d_W;
      target[static_cast<int>(i)] = (length * length - lying.d_W.squaredNorm()) / 2;
    }
    const std::vector<Eigen::Vector3d> moves =
        Kicks(system, d, Responses(system, d).ldlt().solve(target));
    for (std::size_t i = 0; i < state.size(); ++i) state[i].p_W += moves[i];
    if (target.cwiseAbs().maxCoeff() == 0) break;
  }
}

}  // namespace touchstone
