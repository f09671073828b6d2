#include "reports/worlds/truth/net.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace touchstone {
namespace {

constexpr int kMostPasses = 500;

/** A Newton step below this fraction of the size is taken unchecked: second differences
 of a double are lost there, √2⁻⁵³, with a safety factor. [-] */
constexpr double kNear = 1e-6;

/** Returns the row of each point's x in the vectors; −1 if the point is fixed. */
std::vector<int> RowsOf(const Net& net) {
  std::vector<int> rows;
  int next = 0;
  for (const double mass : net.mass) {
    rows.push_back(mass > 0 ? next : -1);
    if (mass > 0) next += 3;
  }
  return rows;
}

int SizeOf(const Net& net) {
  return 3 * static_cast<int>(std::count_if(net.mass.begin(), net.mass.end(),
                                            [](double mass) { return mass > 0; }));
}

const Eigen::Vector3d& At(const Net::Points& points, int index) {
  return points[static_cast<std::size_t>(index)];
}

int Row(const std::vector<int>& rows, int index) {
  return rows[static_cast<std::size_t>(index)];
}

}  // namespace

double Net::EnergyAt(const Points& points_W) const {
  double energy = 0;
  for (std::size_t i = 0; i < mass.size(); ++i) energy -= mass[i] * g_W.dot(points_W[i]);
  for (const Link& link : links) {
    const double stretch =
        (At(points_W, link.b) - At(points_W, link.a)).norm() - link.rest_length;
    energy += link.stiffness * stretch * stretch / 2;
  }
  return energy;
}

Eigen::VectorXd Net::GradientAt(const Points& points_W) const {
  const std::vector<int> rows = RowsOf(*this);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(SizeOf(*this));
  for (std::size_t i = 0; i < mass.size(); ++i) {
    if (rows[i] >= 0) gradient.segment<3>(rows[i]) -= mass[i] * g_W;
  }
  for (const Link& link : links) {
    const Eigen::Vector3d arm_W = At(points_W, link.b) - At(points_W, link.a);
    const double length = arm_W.norm();
    const Eigen::Vector3d pull_W =
        link.stiffness * (length - link.rest_length) / length * arm_W;
    if (Row(rows, link.a) >= 0) gradient.segment<3>(Row(rows, link.a)) -= pull_W;
    if (Row(rows, link.b) >= 0) gradient.segment<3>(Row(rows, link.b)) += pull_W;
  }
  return gradient;
}

Eigen::MatrixXd Net::HessianAt(const Points& points_W) const {
  const std::vector<int> rows = RowsOf(*this);
  const int size = SizeOf(*this);
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size, size);
  for (const Link& link : links) {
    const Eigen::Vector3d arm_W = At(points_W, link.b) - At(points_W, link.a);
    const double length = arm_W.norm();
    const Eigen::Vector3d d_W = arm_W / length;
    // k d dᵀ along the spring, T/|p| across it.
    const double across = link.stiffness * (length - link.rest_length) / length;
    const Eigen::Matrix3d block = across * Eigen::Matrix3d::Identity() +
                                  (link.stiffness - across) * d_W * d_W.transpose();
    const int a = Row(rows, link.a);
    const int b = Row(rows, link.b);
    if (a >= 0) hessian.block<3, 3>(a, a) += block;
    if (b >= 0) hessian.block<3, 3>(b, b) += block;
    if (a >= 0 && b >= 0) {
      hessian.block<3, 3>(a, b) -= block;
      hessian.block<3, 3>(b, a) -= block;
    }
  }
  return hessian;
}

Net::Points Net::Minimum(Points points_W) const {
  const std::vector<int> rows = RowsOf(*this);
  double energy = EnergyAt(points_W);
  double damping = 0;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const Eigen::VectorXd gradient = GradientAt(points_W);
    const Eigen::MatrixXd hessian = HessianAt(points_W);
    const double scale = hessian.diagonal().cwiseAbs().maxCoeff();
    double moved = 0;
    double size = 0;
    for (bool falls = false; !falls;) {
      const Eigen::LLT<Eigen::MatrixXd> factor(
          hessian + damping * Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()));
      Points next = points_W;
      if (factor.info() == Eigen::Success) {
        const Eigen::VectorXd step = -factor.solve(gradient);
        moved = step.cwiseAbs().maxCoeff();
        for (std::size_t i = 0; i < next.size(); ++i) {
          size = std::max(size, next[i].norm());
          if (rows[i] >= 0) next[i] += step.segment<3>(rows[i]);
        }
        const double lower = EnergyAt(next);
        // Near the minimum U changes by less than its rounding; Newton's step is right.
        falls = lower <= energy || moved <= kNear * size;
        if (falls) {
          energy = lower;
          points_W = std::move(next);
          damping = damping < 1e-10 * scale ? 0 : damping / 4;
          continue;
        }
      }
      damping = std::max(4 * damping, 1e-8 * scale);
      if (damping > 1e12 * scale) return points_W;
    }
    if (damping == 0 && moved <= 1e-14 * size) break;
  }
  return points_W;
}

double Decay::Slowest() const {
  const double least = frequencies2.front();
  const double half2 = half_damping * half_damping;
  return half2 > least ? half_damping - std::sqrt(half2 - least) : half_damping;
}

double Decay::LeftAfter(double t) const {
  const double g = half_damping;
  double most = -std::numeric_limits<double>::infinity();
  for (const double w2 : frequencies2) {
    const double m2 = g * g - w2;
    const double m = std::sqrt(std::abs(m2));
    if (m2 > 0 && m * t > 20) {  // sinh ≈ ½ exp, and asinh(x) ≈ log(2 x).
      most = std::max(most, std::log(g / m) + m * t);
    } else if (m * t < 1e-4) {
      most = std::max(most, std::asinh(g * t));
    } else {
      const double S =
          m2 > 0 ? std::sinh(m * t) : std::sin(std::min(m * t, std::numbers::pi / 2));
      most = std::max(most, std::asinh(g * S / m));
    }
  }
  return std::exp(most - g * t);
}

Decay Net::DecayAbout(const Points& points_W, double damping) const {
  const std::vector<int> rows = RowsOf(*this);
  Eigen::MatrixXd scaled = HessianAt(points_W);
  Eigen::VectorXd root(scaled.rows());
  for (std::size_t i = 0; i < mass.size(); ++i) {
    if (rows[i] >= 0) root.segment<3>(rows[i]).setConstant(1 / std::sqrt(mass[i]));
  }
  scaled = root.asDiagonal() * scaled * root.asDiagonal();
  const Eigen::VectorXd frequencies2 =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
          .eigenvalues();
  Decay decay{damping / 2, {}};
  // Ascending. At a minimum only rounding makes one negative.
  for (const double w2 : frequencies2) decay.frequencies2.push_back(std::max(0.0, w2));
  return decay;
}

}  // namespace touchstone
