#include "reports/worlds/truth/catenary.h"

#include <cmath>

#include <Eigen/LU>

namespace touchstone {
namespace {

constexpr int kMostPasses = 200;

/** A Newton step below this fraction of the tension is taken unchecked: second
 differences of a double are lost there, √2⁻⁵³, with a safety factor. [-] */
constexpr double kNear = 1e-6;

/** Fraction of the tension that is rounding. [-] */
constexpr double kRounding = 1e-15;

std::vector<Eigen::Vector3d> TensionsFrom(const HangingChain& chain,
                                          const Eigen::Vector3d& first_W) {
  std::vector<Eigen::Vector3d> tension_W = {first_W};
  for (const Eigen::Vector3d& weight_W : chain.weight_W)
    tension_W.push_back(tension_W.back() - weight_W);
  if (chain.free_end) tension_W.pop_back();
  return tension_W;
}

/** Returns the convex function whose minimum is the equilibrium. [J] */
double Complementary(const HangingChain& chain, const Eigen::Vector3d& first_W) {
  const std::vector<Eigen::Vector3d> tension_W = TensionsFrom(chain, first_W);
  double sum = 0;
  for (std::size_t i = 0; i < tension_W.size(); ++i) {
    sum += chain.rest_length[i] * tension_W[i].norm() +
           tension_W[i].squaredNorm() / (2 * chain.stiffness[i]);
  }
  return sum - first_W.dot(chain.to_W - chain.from_W);
}

Eigen::Vector3d LinkOf(const HangingChain& chain, std::size_t i,
                       const Eigen::Vector3d& tension_W) {
  return tension_W * (chain.rest_length[i] / tension_W.norm() + 1 / chain.stiffness[i]);
}

Eigen::Vector3d FirstTension(const HangingChain& chain) {
  Eigen::Vector3d weight_W = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& one : chain.weight_W) weight_W += one;
  if (chain.free_end) return weight_W;
  const Eigen::Vector3d span_W = chain.to_W - chain.from_W;
  Eigen::Vector3d first_W = weight_W / 2 + weight_W.norm() / 2 * span_W.normalized();
  double value = Complementary(chain, first_W);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    Eigen::Vector3d off_W = -span_W;
    Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
    const std::vector<Eigen::Vector3d> tension_W = TensionsFrom(chain, first_W);
    for (std::size_t i = 0; i < tension_W.size(); ++i) {
      off_W += LinkOf(chain, i, tension_W[i]);
      const double size = tension_W[i].norm();
      const Eigen::Vector3d d_W = tension_W[i] / size;
      slope += chain.rest_length[i] / size *
                   (Eigen::Matrix3d::Identity() - d_W * d_W.transpose()) +
               Eigen::Matrix3d::Identity() / chain.stiffness[i];
    }
    const Eigen::Vector3d step_W = -slope.inverse() * off_W;
    double share = 1;
    double next = Complementary(chain, first_W + step_W);
    // Near the minimum the function changes by less than its rounding; Newton's step is
    // right.
    while (!(next <= value) && share * step_W.norm() > kNear * first_W.norm()) {
      share /= 2;
      next = Complementary(chain, first_W + share * step_W);
    }
    first_W += share * step_W;
    if (step_W.norm() <= kRounding * first_W.norm()) break;
    value = next;
  }
  return first_W;
}

}  // namespace

Catenary CatenaryOf(const HangingChain& chain) {
  Catenary catenary;
  catenary.tension_W = TensionsFrom(chain, FirstTension(chain));
  Eigen::Vector3d at_W = chain.from_W;
  for (std::size_t i = 0; i < chain.weight_W.size(); ++i) {
    at_W += LinkOf(chain, i, catenary.tension_W[i]);
    catenary.points_W.push_back(at_W);
  }
  return catenary;
}

}  // namespace touchstone
