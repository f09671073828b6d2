#include "engine/dynamics/joints/spring.h"

#include <algorithm>
#include <cmath>

namespace cookbook {
namespace {

/** Share of a length below which it is rounded: a few roundings. [-] */
constexpr double kLengthRounding = 1e-15;

/** Returns (d₀ + d₁)/(ℓ₀ + ℓ₁); zero where the ends stay on one another, for there is no
 direction to load in. */
Eigen::Vector3d MeanDirection(const Eigen::Vector3d& d_sum, double length_sum) {
  if (length_sum == 0) return Eigen::Vector3d::Zero();
  return d_sum / length_sum;
}

}  // namespace

Eigen::Vector3d LoadOnA(const Spring& spring, std::span<const RigidBody> bodies) {
  const Eigen::Vector3d d = PlaceOf(spring.B, bodies).p_W - PlaceOf(spring.A, bodies).p_W;
  const double length = d.norm();
  return spring.stiffness * (length - spring.rest_length) * MeanDirection(d, length);
}

void SpringSolver::Want(const Spring& spring, double length, double share, double h,
                        Row& row) {
  const double stretch = 0.5 * (row.length_start + length) - spring.rest_length;
  row.wanted =
      -h * spring.stiffness * stretch - spring.damping * (length - row.length_start);
  // A change of the parting velocity by δ changes ℓ₁ by share h δ.
  row.give = share * h * (0.5 * h * spring.stiffness + spring.damping);
}

void SpringSolver::Begin(std::span<const Spring> springs,
                         std::span<const RigidBody> bodies,
                         std::span<const InverseInertia> inertias,
                         std::span<const Velocity> before, double h) {
  inertias_ = inertias;
  rows_.resize(springs.size());
  for (std::size_t k = 0; k < springs.size(); ++k) {
    Row& row = rows_[k];
    const AnchorPlace a = PlaceOf(springs[k].A, bodies);
    const AnchorPlace b = PlaceOf(springs[k].B, bodies);
    row.d_start = b.p_W - a.p_W;
    row.r_A_start = a.r_W;
    row.r_B_start = b.r_W;
    row.length_start = row.d_start.norm();
    row.line = {springs[k].A.body, springs[k].B.body,
                MeanDirection(row.d_start, row.length_start), a.r_W, b.r_W};
    row.response = row.line.Response(inertias);
    row.expected = row.line.Parting(before);
    row.impulse = 0;
    Want(springs[k], row.length_start + h * row.expected, 0.5, h, row);
  }
}

double SpringSolver::Iterate(std::span<Velocity> velocities) {
  double greatest = 0;
  for (Row& row : rows_) {
    if (row.response == 0) continue;
    const double parting = row.line.Parting(velocities);
    const double missing = row.wanted - row.give * (parting - row.expected) - row.impulse;
    const double change = missing / (1 + row.give * row.response);
    row.impulse += change;
    row.line.Apply(change, inertias_, velocities);
    greatest = std::max(greatest, std::abs(change) * row.response);
  }
  return greatest;
}

double SpringSolver::GreatestLoad() const {
  double greatest = 0;
  for (const Row& row : rows_) {
    greatest = std::max(greatest, std::abs(row.wanted) * row.response);
  }
  return greatest;
}

bool SpringSolver::Correct(std::span<const Spring> springs,
                           std::span<const RigidBody> after,
                           std::span<const double> share, std::span<Velocity> velocities,
                           double h, double solved) {
  bool is_right = true;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    Row& row = rows_[k];
    const AnchorPlace a = PlaceOf(springs[k].A, after);
    const AnchorPlace b = PlaceOf(springs[k].B, after);
    const Eigen::Vector3d d = b.p_W - a.p_W;
    const double length = d.norm();
    const double length_sum = row.length_start + length;
    double moves = 0.5;
    for (const int body : {row.line.A, row.line.B}) {
      if (body >= 0) moves = std::max(moves, share[static_cast<std::size_t>(body)]);
    }
    Want(springs[k], length, moves, h, row);
    // With the length rounds the impulse that follows from it: by ½ h k + b a metre.
    const double rounding = kLengthRounding * length_sum;
    const double rounded = std::abs(row.give / (moves * h)) * row.response * rounding;
    const double off = std::abs(row.wanted - row.impulse) * row.response;
    is_right = is_right && (length_sum == 0 ||
                            (off * std::abs(h) <= rounding && off <= solved + rounded));
    row.line.Apply(-row.impulse, inertias_, velocities);
    row.line.n = MeanDirection(row.d_start + d, length_sum);
    row.line.r_A = 0.5 * (row.r_A_start + a.r_W);
    row.line.r_B = 0.5 * (row.r_B_start + b.r_W);
    row.response = row.line.Response(inertias_);
    row.line.Apply(row.impulse, inertias_, velocities);
    row.expected = row.line.Parting(velocities);
  }
  return is_right;
}

}  // namespace cookbook
