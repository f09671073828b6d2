#include "engine/dynamics/widest_contacts.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace cookbook {
namespace {

/** How much wider a contact is taken for that was there before. */
constexpr double kKnown = 1.1;

}  // namespace

void KeepWidest(std::span<const ContactPoint> before, Manifold& manifold) {
  if (manifold.count <= kContactsOfFace) return;
  const std::span<const ContactPoint> contacts = manifold.points();
  std::array<double, 8> share{};
  std::array<Eigen::Vector3d, 8> arm;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const ContactPoint& contact : contacts) middle += contact.p_WC;
  middle /= static_cast<double>(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto is_same = [&](const ContactPoint& known) {
      return known.feature == contacts[k].feature;
    };
    share[k] = std::any_of(before.begin(), before.end(), is_same) ? kKnown : 1;
    arm[k] = contacts[k].p_WC - middle;
  }
  // The contact of which a measure is greatest, and is greater than 0.
  const auto greatest = [&](const auto& measure) {
    std::size_t best = contacts.size();
    double most = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const double value = share[k] * measure(arm[k]);
      if (value <= most) continue;
      most = value;
      best = k;
    }
    return best;
  };
  const std::size_t first =
      greatest([](const Eigen::Vector3d& r) { return r.squaredNorm(); });
  if (first == contacts.size()) return;
  const Eigen::Vector3d start = arm[first];
  const std::size_t second =
      greatest([&](const Eigen::Vector3d& r) { return (r - start).squaredNorm(); });
  const Eigen::Vector3d across = manifold.n_AB_W.cross(arm[second] - start);
  const std::size_t left =
      greatest([&](const Eigen::Vector3d& r) { return across.dot(r - start); });
  const std::size_t right =
      greatest([&](const Eigen::Vector3d& r) { return -across.dot(r - start); });
  int count = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (k != first && k != second && k != left && k != right) continue;
    manifold.contacts[static_cast<std::size_t>(count++)] = contacts[k];
  }
  manifold.count = count;
}

}  // namespace cookbook
