#include "engine/dynamics/projection.h"

#include <algorithm>

namespace cookbook {

bool Projection::FindMoves(const ContactSolver& contacts,
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
  contacts.ForEachBelow(-slack, [&](const SolvedContact& contact) {
    if (contact.bounces) return;
    const auto a = static_cast<std::size_t>(contact.A);
    const auto b = static_cast<std::size_t>(contact.B);
    const double gone =
        h * contact.n.dot(mean[b].At(contact.r_B) - mean[a].At(contact.r_A));
    const double excess = -(contact.separation + gone) - slack;
    if (excess <= 0) return;
    // What parts by itself needs no help, and help would be energy from nowhere.
    const double parting =
        contact.n.dot(solved[b].At(contact.r_B) - solved[a].At(contact.r_A));
    if (parting > gravity_speed + settings.projection_share * excess / h) return;
    overlaps_.push_back({contact, settings.projection_share * excess});
  });
  if (overlaps_.empty()) return false;

  std::fill(moves.begin(), moves.end(), Velocity{});
  for (int sweep = 0; sweep < settings.projection_iterations; ++sweep) {
    for (Overlap& overlap : overlaps_) {
      const SolvedContact& contact = overlap.contact;
      const auto a = static_cast<std::size_t>(contact.A);
      const auto b = static_cast<std::size_t>(contact.B);
      const double mass =
          linear ? 1 / (inertias[a].mass + inertias[b].mass) : contact.effective_mass;
      const double gained =
          contact.n.dot(moves[b].At(contact.r_B) - moves[a].At(contact.r_A));
      const double impulse =
          std::max(0.0, overlap.impulse + mass * (overlap.excess - gained));
      const Eigen::Vector3d J = (impulse - overlap.impulse) * contact.n;
      overlap.impulse = impulse;
      moves[a].v -= inertias[a].mass * J;
      moves[b].v += inertias[b].mass * J;
      if (linear) continue;
      moves[a].w -= inertias[a].tensor_W * contact.r_A.cross(J);
      moves[b].w += inertias[b].tensor_W * contact.r_B.cross(J);
    }
  }
  return true;
}

}  // namespace cookbook
