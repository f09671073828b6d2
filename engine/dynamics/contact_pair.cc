#include "engine/dynamics/contact_pair.h"

#include <algorithm>

#include <Eigen/LU>

#include "engine/dynamics/near_contact.h"

namespace cookbook {
namespace {

/** A contact no further from where an old one was than this share of the smaller body is
 the old one under a new name: where edges coincide, rounding chooses which of them makes
 a corner. */
constexpr double kSamePlace = 0.05;

/** Spreads the impulses along the normal as a stiff even bed would carry the same load:
 linear in the place, of the same sum and the same moments. Four contacts or more hold a
 face in more ways than one, and which of them sweeps find, and carry on from step to
 step, hangs on their order; how a face slides hangs on the way.

 λ' = λ̄ + g·(x − x̄), g the least squares of λ − λ̄: of all λ of these sums the one of least
 Σ λ². Left alone where a contact carries nothing, or would pull. */
void SpreadLoad(ContactPair& pair) {
  const Manifold& manifold = pair.manifold;
  const std::size_t count = manifold.points().size();
  if (count < 4) return;
  const Eigen::Vector3d& n = manifold.n_AB_W;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  std::array<double, 8> load;
  double mean = 0;
  for (std::size_t i = 0; i < count; ++i) {
    load[i] = pair.J_W[i].dot(n);
    if (load[i] <= 0) return;
    mean += load[i];
    centre += manifold.contacts[i].p_WC;
  }
  mean /= static_cast<double>(count);
  centre /= static_cast<double>(count);
  const Eigen::Vector3d t1 = n.unitOrthogonal();
  const Eigen::Vector3d t2 = n.cross(t1);
  std::array<Eigen::Vector2d, 8> place;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d arm = manifold.contacts[i].p_WC - centre;
    place[i] = {arm.dot(t1), arm.dot(t2)};
    spread += place[i] * place[i].transpose();
    moment += (load[i] - mean) * place[i];
  }
  // Contacts on a line have no gradient across it.
  const double determinant = spread.determinant();
  if (determinant <= 1e-12 * spread.trace() * spread.trace()) return;
  const Eigen::Vector2d gradient = spread.inverse() * moment;
  std::array<double, 8> even;
  for (std::size_t i = 0; i < count; ++i) {
    even[i] = mean + gradient.dot(place[i]);
    if (even[i] <= 0) return;
  }
  for (std::size_t i = 0; i < count; ++i) pair.J_W[i] += (even[i] - load[i]) * n;
}

/** Gives the contacts of `pair` the impulses of the old contacts of the same features;
 of those left over, one within `reach` [m]. */
void PassOn(const Manifold& old, const std::array<Eigen::Vector3d, 8>& old_J_W,
            double reach, ContactPair& pair) {
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

}  // namespace

void Recollide(double margin, const RigidBody& A, const RigidBody& B, ContactPair& pair) {
  const Manifold old = pair.manifold;
  const std::array<Eigen::Vector3d, 8> old_J_W = pair.J_W;
  const Eigen::Vector3d guess =
      old.count > 0 ? old.n_AB_W : Eigen::Vector3d(Eigen::Vector3d::Zero());
  pair.manifold = CollideWithin(margin, A, B, guess);

  const double smaller = A.is_static()   ? B.radius
                         : B.is_static() ? A.radius
                                         : std::min(A.radius, B.radius);
  PassOn(old, old_J_W, kSamePlace * smaller, pair);
  SpreadLoad(pair);
}

}  // namespace cookbook
