#include "engine/dynamics/contact_pair.h"

#include <algorithm>

#include "engine/dynamics/near_contact.h"

namespace cookbook {
namespace {

/** A contact no further from where an old one was than this share of the smaller body is
 the old one under a new name: where edges coincide, rounding chooses which of them makes
 a corner. */
constexpr double kSamePlace = 0.05;

}  // namespace

void Recollide(double margin, const RigidBody& A, const RigidBody& B, ContactPair& pair) {
  const Manifold old = pair.manifold;
  const std::array<Eigen::Vector3d, 8> old_J_W = pair.J_W;
  const Eigen::Vector3d guess =
      old.count > 0 ? old.n_AB_W : Eigen::Vector3d(Eigen::Vector3d::Zero());
  pair.manifold = CollideWithin(margin, A, B, guess);

  const Manifold& now = pair.manifold;
  unsigned taken = 0;    // Old contacts whose impulse has been passed on.
  unsigned settled = 0;  // New contacts that have one.
  for (std::size_t i = 0; i < now.points().size(); ++i) {
    pair.J_W[i].setZero();
    for (std::size_t k = 0; k < old.points().size(); ++k) {
      if (old.contacts[k].feature != now.contacts[i].feature) continue;
      pair.J_W[i] = old_J_W[k];
      taken |= 1u << k;
      settled |= 1u << i;
      break;
    }
  }
  if (settled + 1 == 1u << now.points().size()) return;
  const double reach = kSamePlace * (B.is_static() || A.is_static()
                                         ? std::max(A.is_static() ? 0 : A.radius,
                                                    B.is_static() ? 0 : B.radius)
                                         : std::min(A.radius, B.radius));
  for (std::size_t i = 0; i < now.points().size(); ++i) {
    if (settled >> i & 1) continue;
    for (std::size_t k = 0; k < old.points().size(); ++k) {
      if (taken >> k & 1) continue;
      const Eigen::Vector3d step = now.contacts[i].p_WC - old.contacts[k].p_WC;
      if (step.squaredNorm() > reach * reach) continue;
      pair.J_W[i] = old_J_W[k];
      taken |= 1u << k;
      break;
    }
  }
}

}  // namespace cookbook
