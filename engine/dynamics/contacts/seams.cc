#include "engine/dynamics/contacts/seams.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

namespace cookbook {
namespace {

/** How far boxes that fit together may be apart, or one above the other, as a fraction of
 the radius of the body that moves over them: it bears no more on a step that low. [-] */
constexpr double kFlush = 1e-6;

/** How far a normal may be tilted out of those of a box. [rad] */
constexpr double kParallel = 1e-6;

bool IsStaticBox(const RigidBody& body) {
  return body.is_static() && std::holds_alternative<Box>(body.shape);
}

/** Returns whether p_W is a point of a box at which `n_W` is no outward normal. */
bool IsPointWithoutNormal(const RigidBody& box, const Eigen::Vector3d& p_W,
                          const Eigen::Vector3d& n_W, double tolerance) {
  const Eigen::Vector3d p = box.R_WB.transpose() * (p_W - box.state.p_WB);
  const Eigen::Vector3d n = box.R_WB.transpose() * n_W;
  const Eigen::Vector3d& half = std::get<Box>(box.shape).half_extents;
  bool is_normal = true;
  for (int i = 0; i < 3; ++i) {
    const double inside = half[i] - std::abs(p[i]);
    if (inside < -tolerance) return false;
    // On the surface the normals point outwards; within it there is none along the axis.
    const bool fits = inside <= tolerance ? std::copysign(1.0, p[i]) * n[i] >= -kParallel
                                          : std::abs(n[i]) <= kParallel;
    is_normal = is_normal && fits;
  }
  return !is_normal;
}

/** A contact pair of a dynamic body and a static box. */
struct Support {
  const RigidBody& box;
  std::span<const ContactPoint> contacts;
  Eigen::Vector3d n_W;  ///< Out of the box.
  double tolerance;     ///< How far apart flush surfaces may be. [m]

  /** Returns the contact point on the box; `contact` has that on the dynamic body. */
  Eigen::Vector3d OnBox(const ContactPoint& contact) const {
    return contact.p_WC - contact.separation * n_W;
  }
};

Support SupportOf(const ContactPair& pair, std::span<const RigidBody> bodies) {
  const RigidBody& A = bodies[static_cast<std::size_t>(pair.A)];
  const RigidBody& B = bodies[static_cast<std::size_t>(pair.B)];
  const Eigen::Vector3d& n_AB_W = pair.manifold.n_AB_W;
  return {A.is_static() ? A : B, pair.manifold.points(),
          A.is_static() ? n_AB_W : Eigen::Vector3d(-n_AB_W),
          kFlush * SmallerRadius(A, B)};
}

/** Returns whether `box` is nowhere above the plane of the contact with `support`. */
bool IsBelow(const RigidBody& box, const Support& support) {
  const Eigen::Vector3d& n_W = support.n_W;
  const Eigen::Vector3d& half = std::get<Box>(box.shape).half_extents;
  const double reach = half.dot((box.R_WB.transpose() * n_W).cwiseAbs());
  const Eigen::Vector3d p_W = support.OnBox(support.contacts.front());
  return n_W.dot(box.state.p_WB - p_W) + reach <= support.tolerance;
}

/** Returns whether a contact is one with a seam of its box and that of `other`. */
bool IsOnSeam(const Support& contact, const Support& other) {
  return IsBelow(contact.box, other) &&
         std::ranges::all_of(contact.contacts, [&](const ContactPoint& point) {
           return IsPointWithoutNormal(other.box, contact.OnBox(point), contact.n_W,
                                       contact.tolerance);
         });
}

}  // namespace

void Seams::RemoveContacts(std::span<const RigidBody> bodies, ContactCache& cache) {
  const std::span<const PairSummary> summaries = cache.summaries();
  last_.assign(bodies.size(), -1);
  previous_.assign(summaries.size(), -1);
  found_.clear();
  const auto is_box = [&](int body) {
    return IsStaticBox(bodies[static_cast<std::size_t>(body)]);
  };
  for (std::size_t k = 0; k < summaries.size(); ++k) {
    const auto& [A, B, count] = summaries[k];
    if (count == 0 || is_box(A) == is_box(B)) continue;
    int& last = last_[static_cast<std::size_t>(is_box(A) ? B : A)];
    previous_[k] = std::exchange(last, static_cast<int>(k));
  }
  const std::span<const ContactPair> pairs = cache.pairs();
  for (const int last : last_) {
    if (last < 0 || previous_[static_cast<std::size_t>(last)] < 0) continue;
    for (int k = last; k >= 0; k = previous_[static_cast<std::size_t>(k)]) {
      const auto pair = static_cast<std::size_t>(k);
      for (int j = last; j >= 0; j = previous_[static_cast<std::size_t>(j)]) {
        const auto other = static_cast<std::size_t>(j);
        if (j == k ||
            !IsOnSeam(SupportOf(pairs[pair], bodies), SupportOf(pairs[other], bodies)))
          continue;
        found_.push_back(pair);
        break;
      }
    }
  }
  for (const std::size_t pair : found_) cache.ClearContacts(pair);
}

}  // namespace cookbook
