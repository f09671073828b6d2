#include "engine/dynamics/contacts/contact_pair.h"

#include <algorithm>

#include "engine/dynamics/contacts/collide_bodies.h"
#include "engine/dynamics/contacts/reduce_manifold.h"

namespace cookbook {
namespace {

/** Distance, as a fraction of the radius of the smaller body, below which a contact point
 is matched with an old one of a different feature: if edges coincide, rounding decides
 which of them makes a corner. */
constexpr double kMatchDistance = 0.05;

/** The contact points of a pair in the previous step. */
struct OldManifold {
  std::size_t count;
  std::array<ContactPoint, 8> contacts;

  void Store(const Manifold& manifold) {
    count = manifold.points().size();
    std::copy_n(manifold.contacts.begin(), count, contacts.begin());
  }
};

bool HasSameFeatures(const OldManifold& old, const Manifold& now) {
  if (old.count != now.points().size()) return false;
  for (std::size_t i = 0; i < old.count; ++i) {
    if (old.contacts[i].feature != now.contacts[i].feature) return false;
  }
  return true;
}

/** Transfers impulses from old to new contact points: first between those of the same
 feature, then between the others within `reach` [m]. */
void TransferImpulses(const OldManifold& old, double reach, ContactPair& pair) {
  const Manifold& now = pair.manifold;
  const std::array<Eigen::Vector3d, 8> old_J_W = pair.J_W;
  const std::array<double, 8> old_mean_load = pair.mean_load;
  if (old.count == 0) pair.loaded_steps = 0;
  unsigned used = 0;     // Old contact points whose impulse is transferred.
  unsigned matched = 0;  // New contact points that have an impulse.
  for (std::size_t i = 0; i < now.points().size(); ++i) {
    pair.J_W[i].setZero();
    pair.mean_load[i] = 0;
    for (std::size_t k = 0; k < old.count; ++k) {
      if (old.contacts[k].feature != now.contacts[i].feature) continue;
      pair.J_W[i] = old_J_W[k];
      pair.mean_load[i] = old_mean_load[k];
      used |= 1u << k;
      matched |= 1u << i;
      break;
    }
  }
  if (matched + 1 == 1u << now.points().size()) return;
  for (std::size_t i = 0; i < now.points().size(); ++i) {
    if (matched >> i & 1) continue;
    for (std::size_t k = 0; k < old.count; ++k) {
      if (used >> k & 1) continue;
      const Eigen::Vector3d offset = now.contacts[i].p_WC - old.contacts[k].p_WC;
      if (offset.squaredNorm() > reach * reach) continue;
      pair.J_W[i] = old_J_W[k];
      pair.mean_load[i] = old_mean_load[k];
      used |= 1u << k;
      break;
    }
  }
}

}  // namespace

double LoadAccelerationOn(const ContactPair& pair, const RigidBody& A,
                          const RigidBody& B) {
  const double own = LoadAccelerationBetween(A, B);
  const double of_island = IslandLoadAccelerationBetween(A, B);
  if (of_island <= own) return own;
  const bool is_pressed =
      std::any_of(pair.J_W.begin(), pair.J_W.begin() + pair.manifold.count,
                  [](const Eigen::Vector3d& J) { return !J.isZero(0); });
  return is_pressed ? of_island : own;
}

void UpdateManifolds(const ContactOptions& options, std::span<const RigidBody> bodies,
                     std::span<ContactPair* const> pairs) {
  std::array<OldManifold, kPairsPerBatch> old;
  std::array<CollisionPair, kPairsPerBatch> batch;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    ContactPair& pair = *pairs[k];
    const RigidBody& A = bodies[static_cast<std::size_t>(pair.A)];
    const RigidBody& B = bodies[static_cast<std::size_t>(pair.B)];
    old[k].Store(pair.manifold);
    batch[k] = {&A, &B, std::min(options.margin, SpeculativeMarginBetween(A, B)),
                Eigen::Vector3d::Zero(), &pair.manifold};
    if (old[k].count > 0) batch[k].n_guess_W = pair.manifold.n_AB_W;
  }
  CollideSpeculative(std::span(batch).first(pairs.size()));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    // Contacts with a half-space need not be on one face: all corners of a box may be
    // within the margin.
    if (options.reduce_manifold && AreBoxes(*batch[k].A, *batch[k].B))
      ReduceManifold(std::span(old[k].contacts).first(old[k].count), pairs[k]->manifold);
    if (HasSameFeatures(old[k], pairs[k]->manifold)) continue;
    const RigidBody& A = *batch[k].A;
    const RigidBody& B = *batch[k].B;
    TransferImpulses(old[k], kMatchDistance * SmallerRadius(A, B), *pairs[k]);
  }
}

}  // namespace cookbook
