#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/contacts/collide_boxes_simd.h"
#include "engine/threads/prefetch.h"

namespace cookbook {

/** Two bodies that are near each other: how they touch, and the impulses that held them
 apart in the last step. */
struct alignas(64) ContactPair {
  int A = 0;
  int B = 0;
  std::size_t near = 0;  ///< Where ContactCache keeps it.
  Manifold manifold;     ///< See CollideSpeculative().
  /** Impulse on B at each contact of the manifold. World frame. [N s] */
  alignas(64) std::array<Eigen::Vector3d, 8> J_W;
};

/** What is asked of a pair most, side by side with those of the others: pairs are large.
 */
struct ContactEdge {
  int A;
  int B;
  int count;  ///< Of contacts.
};

/** Tells memory that so many contacts of `pair` and their impulses will be wanted soon.
 */
inline void PrefetchContacts(const ContactPair& pair, int contacts) {
  const auto count = static_cast<std::size_t>(contacts);
  Prefetch(&pair, offsetof(ContactPair, manifold) + offsetof(Manifold, contacts) +
                      count * sizeof(ContactPoint));
  Prefetch(&pair.J_W, count * sizeof(Eigen::Vector3d));
}

/** Returns how hard the two bodies of `pair` are pulled; as hard as their island, where
 they pressed each other in the last step. [m/s²] */
double LoadOn(const ContactPair& pair, const RigidBody& A, const RigidBody& B);

/** Which contacts are kept. */
struct ContactChoice {
  double margin;         ///< Those apart by no more, and no more than
                         ///< SpeculativeMarginBetween(). [m]
  bool reduce_manifold;  ///< Of a face the few that hold it widest, see ReduceManifold().
};

/** Replaces the manifolds of at most kNeighbours pairs by those of their bodies as they
 are now. The impulse of a contact is that of the old contact of the same feature; new
 contacts start at zero. */
void Recollide(const ContactChoice& choice, std::span<const RigidBody> bodies,
               std::span<ContactPair* const> pairs);

}  // namespace cookbook
