#include "engine/dynamics/projection.h"

#include <algorithm>

namespace cookbook {

bool Projection::FindMoves(const ContactSolver& contacts,
                           std::span<const ContactPair> pairs,
                           std::span<const InverseInertia> inertias,
                           std::span<const Velocity> mean,
                           std::span<const Velocity> solved, const Settings& settings,
                           double h, std::span<Velocity> moves) {
  const bool linear = settings.stabilisation == Stabilisation::kLinearProjection;
  if (!linear && settings.stabilisation != Stabilisation::kNonLinearProjection) {
    return false;
  }
  const double gravity_speed = h * settings.gravity_W.norm();
  const double slack = SlackOf(settings, h);
  overlaps_.clear();
  for (const ContactSolver::Rows& rows : contacts.rows()) {
    const auto a = static_cast<std::size_t>(rows.A);
    const auto b = static_cast<std::size_t>(rows.B);
    const Manifold& manifold = pairs[rows.pair].manifold;
    for (int i = 0; i < rows.count; ++i) {
      const ContactSolver::Row& row = rows.rows[static_cast<std::size_t>(i)];
      if (row.bounces) continue;
      const double gone = h * rows.n.dot(mean[b].At(row.r_B) - mean[a].At(row.r_A));
      const double excess =
          -(manifold.contacts[static_cast<std::size_t>(i)].separation + gone) - slack;
      if (excess <= 0) continue;
      // What parts by itself needs no help, and help would be energy from nowhere.
      const double parting = rows.n.dot(solved[b].At(row.r_B) - solved[a].At(row.r_A));
      if (parting > gravity_speed + settings.projection_share * excess / h) continue;
      if (linear && !overlaps_.empty() && overlaps_.back().pair == &rows) {
        Overlap& last = overlaps_.back();
        last.excess = std::max(last.excess, settings.projection_share * excess);
      } else {
        overlaps_.push_back({&rows, &row, settings.projection_share * excess});
      }
    }
  }
  if (overlaps_.empty()) return false;

  std::fill(moves.begin(), moves.end(),
            Velocity{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  if (linear) {
    for (const Overlap& overlap : overlaps_) {
      const auto a = static_cast<std::size_t>(overlap.pair->A);
      const auto b = static_cast<std::size_t>(overlap.pair->B);
      const Eigen::Vector3d s =
          overlap.excess / (inertias[a].mass + inertias[b].mass) * overlap.pair->n;
      moves[a].v -= inertias[a].mass * s;
      moves[b].v += inertias[b].mass * s;
    }
    return true;
  }
  for (int sweep = 0; sweep < settings.projection_iterations; ++sweep) {
    for (Overlap& overlap : overlaps_) {
      const auto a = static_cast<std::size_t>(overlap.pair->A);
      const auto b = static_cast<std::size_t>(overlap.pair->B);
      const Eigen::Vector3d& n = overlap.pair->n;
      const ContactSolver::Row& row = *overlap.row;
      const double gained = n.dot(moves[b].At(row.r_B) - moves[a].At(row.r_A));
      const double impulse =
          std::max(0.0, overlap.impulse + row.effective_mass * (overlap.excess - gained));
      const Eigen::Vector3d J = (impulse - overlap.impulse) * n;
      overlap.impulse = impulse;
      moves[a].v -= inertias[a].mass * J;
      moves[a].w -= inertias[a].tensor_W * row.r_A.cross(J);
      moves[b].v += inertias[b].mass * J;
      moves[b].w += inertias[b].tensor_W * row.r_B.cross(J);
    }
  }
  return true;
}

}  // namespace cookbook
