#include "engine/dynamics/contacts/reduce_manifold.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <Eigen/Geometry>

namespace cookbook {
namespace {

/** How much wider a contact is taken for that was there before. */
constexpr double kKnown = 1.1;

/** Contacts, and how wide each is taken for. */
struct Outline {
  std::span<const ContactPoint> contacts;
  std::array<double, 8> share{};

  /** Returns the contact of which `measure(p_WC)` is greatest, and is above 0; none: the
   number of contacts. */
  template <class Measure>
  std::size_t Greatest(const Measure& measure) const {
    std::size_t best = contacts.size();
    double greatest = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const double value = share[k] * measure(contacts[k].p_WC);
      if (value <= greatest) continue;
      greatest = value;
      best = k;
    }
    return best;
  }

  /** Returns the contact farthest from `p_W`; the first where all are there. */
  std::size_t Farthest(const Eigen::Vector3d& p_W) const {
    const std::size_t farthest =
        Greatest([&](const Eigen::Vector3d& p) { return (p - p_W).squaredNorm(); });
    return farthest < contacts.size() ? farthest : 0;
  }
};

}  // namespace

void ReduceManifold(std::span<const ContactPoint> before, Manifold& manifold) {
  if (manifold.count <= kContactsPerFace) return;
  Outline outline{manifold.points()};
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < outline.contacts.size(); ++k) {
    const ContactPoint& contact = outline.contacts[k];
    middle += contact.p_WC;
    const bool is_known = std::any_of(
        before.begin(), before.end(),
        [&](const ContactPoint& known) { return known.feature == contact.feature; });
    outline.share[k] = is_known ? kKnown : 1;
  }
  middle /= manifold.count;
  const std::size_t first = outline.Farthest(middle);
  const Eigen::Vector3d start = outline.contacts[first].p_WC;
  const std::size_t second = outline.Farthest(start);
  const Eigen::Vector3d across =
      manifold.n_AB_W.cross(outline.contacts[second].p_WC - start);
  const std::size_t left =
      outline.Greatest([&](const Eigen::Vector3d& p) { return across.dot(p - start); });
  const std::size_t right =
      outline.Greatest([&](const Eigen::Vector3d& p) { return -across.dot(p - start); });
  manifold.count = 0;
  for (std::size_t k = 0; k < outline.contacts.size(); ++k) {
    if (k != first && k != second && k != left && k != right) continue;
    manifold.contacts[static_cast<std::size_t>(manifold.count++)] = outline.contacts[k];
  }
}

}  // namespace cookbook
