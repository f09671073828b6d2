#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/collision/manifold.h"
#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/contacts/collide_boxes_simd.h"
#include "engine/threads/prefetch.h"

namespace cookbook {

/** A contact pair, two bodies that touch or nearly do: the manifold, and the impulses of
 the last step for warm starting. */
// The padding is that of cache lines.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
struct alignas(64) ContactPair {
  int A = 0;             ///< Index of a body.
  int B = 0;             ///< Index of a body.
  std::size_t near = 0;  ///< Index of its near pair in ContactCache.
  Manifold manifold;     ///< See CollideSpeculative().
  /** Impulse on B at each contact point of the manifold. World frame. [N s] */
  alignas(64) std::array<Eigen::Vector3d, 8> J_W;
  /** Mean normal impulse of a sub-step at each contact point, see
   Settings::contact_frequency. [N s] */
  std::array<double, 8> mean_load{};
  /** The time in which the impulses and mean loads acted: the last sub-step, or the part
   of it that was solved last. 0: that of the next one. [s] */
  double impulse_time = 0;
  int loaded_steps = 0;  ///< Sub-steps since the pair first was at rest under a load.
};

/** The most used members of a ContactPair, which is large. */
struct PairSummary {
  int A;
  int B;
  int count;  ///< Number of contact points.
};

/** Prefetches the first `contacts` contact points of `pair` and their impulses. */
inline void PrefetchContacts(const ContactPair& pair, int contacts) {
  const auto count = static_cast<std::size_t>(contacts);
  Prefetch(&pair, offsetof(ContactPair, manifold) + offsetof(Manifold, contacts) +
                      count * sizeof(ContactPoint));
  Prefetch(&pair.J_W, count * sizeof(Eigen::Vector3d));
}

/** Returns the load of the two bodies of `pair`, or that of their island if they pressed
 on each other in the last step. [m/s²] */
double LoadAccelerationOn(const ContactPair& pair, const RigidBody& A,
                          const RigidBody& B);

/** Options of the narrow phase. */
struct ContactOptions {
  double margin;         ///< Upper bound on the speculative margin of a pair. [m]
  bool reduce_manifold;  ///< Whether faces are reduced, see ReduceManifold().
};

/** Updates the manifolds of at most kPairsPerBatch pairs. A contact point keeps the
 impulse of the old one with the same feature or nearly the same position; the impulse of
 any other is zero. */
void UpdateManifolds(const ContactOptions& options, std::span<const RigidBody> bodies,
                     std::span<ContactPair* const> pairs);

}  // namespace cookbook
