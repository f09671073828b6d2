#include "engine/dynamics/joints/rod_projection.h"

#include <limits>

namespace cookbook {
namespace {

/** Compliance of a rod relative to its response. Without it the equations of redundant
 rods would be singular. It delays convergence by this factor, and does not change the
 solution. */
constexpr double kCompliance = 1e-13;
/** Number of solutions, each of the error that the last one left. The second leaves
 roundings. */
constexpr int kRefinements = 2;

/** Returns the change of the rate of `rod` by the unit impulse that `other` gives to
 `body`, an end of both. [1/kg] */
double ResponseOf(const AxialConstraint& rod, const AxialConstraint& other, int body,
                  const InverseInertia& inertia) {
  const auto arm = [&](const AxialConstraint& one) -> const Eigen::Vector3d& {
    return one.A == body ? one.r_A : one.r_B;
  };
  const double sign = (rod.A == body) == (other.A == body) ? 1 : -1;
  return sign * (inertia.mass * rod.n.dot(other.n) +
                 arm(rod).cross(rod.n).dot(inertia.Times(arm(other).cross(other.n))));
}

}  // namespace

void RodProjection::Begin(std::span<const DistanceJoint> joints,
                          std::span<const RigidBody> bodies,
                          std::span<const InverseInertia> inertias) {
  inertias_ = inertias;
  rods_.clear();
  std::vector<std::vector<int>> rods_of(bodies.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const DistanceJoint& joint : joints) {
    const AnchorPoint a = LocateAnchor(joint.A, bodies);
    const AnchorPoint b = LocateAnchor(joint.B, bodies);
    const Eigen::Vector3d d = b.p_W - a.p_W;
    const double length = d.norm();
    if (length < std::numeric_limits<double>::min()) continue;
    const AxialConstraint rod{joint.A.body, joint.B.body, d / length, a.r_W, b.r_W};
    const double response = rod.InverseEffectiveMass(inertias);
    if (response == 0) continue;
    const int row = static_cast<int>(rods_.size());
    rods_.push_back(rod);
    entries.emplace_back(row, row, response * kCompliance);
    for (const int body : {rod.A, rod.B}) {
      if (body < 0) continue;
      const auto i = static_cast<std::size_t>(body);
      rods_of[i].push_back(row);
      for (const int column : rods_of[i]) {
        const double entry =
            ResponseOf(rod, rods_[static_cast<std::size_t>(column)], body, inertias[i]);
        entries.emplace_back(row, column, entry);
        if (column != row) entries.emplace_back(column, row, entry);
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(rods_.size());
  rates_.resize(size);
  if (rods_.empty()) return;
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors_.compute(matrix);
}

void RodProjection::Project(std::span<Velocity> velocities) {
  if (rods_.empty()) return;
  for (int refinement = 0; refinement < kRefinements; ++refinement) {
    for (std::size_t k = 0; k < rods_.size(); ++k)
      rates_[static_cast<Eigen::Index>(k)] = rods_[k].RelativeVelocity(velocities);
    const Eigen::VectorXd impulses = factors_.solve(rates_);
    for (std::size_t k = 0; k < rods_.size(); ++k)
      rods_[k].ApplyImpulse(-impulses[static_cast<Eigen::Index>(k)], inertias_,
                            velocities);
  }
}

}  // namespace cookbook
