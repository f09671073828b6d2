#include "engine/dynamics/contacts/contact_pair.h"

#include <algorithm>

#include "engine/dynamics/contacts/collide_bodies.h"
#include "engine/dynamics/contacts/reduce_manifold.h"

namespace cookbook {
namespace {

/** A contact no further from where an old one was than this share of the smaller body is
 the old one under a new name: where edges coincide, rounding chooses which of them makes
 a corner. */
constexpr double kSamePlace = 0.05;

/** The contacts of a pair in the step before. */
struct OldContacts {
  std::size_t count;
  std::array<ContactPoint, 8> contacts;

  void Note(const Manifold& manifold) {
    count = manifold.points().size();
    std::copy_n(manifold.contacts.begin(), count, contacts.begin());
  }
};

bool HasSameFeatures(const OldContacts& old, const Manifold& now) {
  if (old.count != now.points().size()) return false;
  for (std::size_t i = 0; i < old.count; ++i) {
    if (old.contacts[i].feature != now.contacts[i].feature) return false;
  }
  return true;
}

/** Gives the contacts of `pair` the impulses of the old contacts of the same features;
 of those left over, one within `reach` [m]. */
void PassOn(const OldContacts& old, double reach, ContactPair& pair) {
  const Manifold& now = pair.manifold;
  const std::array<Eigen::Vector3d, 8> old_J_W = pair.J_W;
  unsigned taken = 0;    // Old contacts whose impulse has been passed on.
  unsigned settled = 0;  // New contacts that have one.
  for (std::size_t i = 0; i < now.points().size(); ++i) {
    pair.J_W[i].setZero();
    for (std::size_t k = 0; k < old.count; ++k) {
      if (old.contacts[k].feature != now.contacts[i].feature) continue;
      pair.J_W[i] = old_J_W[k];
      taken |= 1u << k;
      settled |= 1u << i;
      break;
    }
  }
  if (settled + 1 == 1u << now.points().size()) return;
  for (std::size_t i = 0; i < now.points().size(); ++i) {
    if (settled >> i & 1) continue;
    for (std::size_t k = 0; k < old.count; ++k) {
      if (taken >> k & 1) continue;
      const Eigen::Vector3d step = now.contacts[i].p_WC - old.contacts[k].p_WC;
      if (step.squaredNorm() > reach * reach) continue;
      pair.J_W[i] = old_J_W[k];
      taken |= 1u << k;
      break;
    }
  }
}

}  // namespace

double LoadOn(const ContactPair& pair, const RigidBody& A, const RigidBody& B) {
  const double own = LoadBetween(A, B);
  const double of_heap = IslandLoadBetween(A, B);
  if (of_heap <= own) return own;
  const bool press = std::any_of(pair.J_W.begin(), pair.J_W.begin() + pair.manifold.count,
                                 [](const Eigen::Vector3d& J) { return !J.isZero(0); });
  return press ? of_heap : own;
}

void Recollide(const ContactChoice& choice, std::span<const RigidBody> bodies,
               std::span<ContactPair* const> pairs) {
  std::array<OldContacts, kNeighbours> old;
  std::array<Neighbours, kNeighbours> neighbours;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    ContactPair& pair = *pairs[k];
    const RigidBody& A = bodies[static_cast<std::size_t>(pair.A)];
    const RigidBody& B = bodies[static_cast<std::size_t>(pair.B)];
    old[k].Note(pair.manifold);
    neighbours[k] = {&A, &B, std::min(choice.margin, SpeculativeMarginBetween(A, B)),
                     Eigen::Vector3d::Zero(), &pair.manifold};
    if (old[k].count > 0) neighbours[k].n_guess_W = pair.manifold.n_AB_W;
  }
  CollideSpeculative(std::span(neighbours).first(pairs.size()));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    // With a half-space they are no face: all corners of a box may be within the margin.
    if (choice.reduce_manifold && AreBoxes(*neighbours[k].A, *neighbours[k].B))
      ReduceManifold(std::span(old[k].contacts).first(old[k].count), pairs[k]->manifold);
    if (HasSameFeatures(old[k], pairs[k]->manifold)) continue;
    const RigidBody& A = *neighbours[k].A;
    const RigidBody& B = *neighbours[k].B;
    const double smaller = A.is_static()   ? B.radius
                           : B.is_static() ? A.radius
                                           : std::min(A.radius, B.radius);
    PassOn(old[k], kSamePlace * smaller, *pairs[k]);
  }
}

}  // namespace cookbook
