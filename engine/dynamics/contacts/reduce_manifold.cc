#include "engine/dynamics/contacts/reduce_manifold.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <Eigen/Geometry>

namespace cookbook {
namespace {

/** Weight of a contact point whose feature was in the previous manifold. */
constexpr double kOldFeatureWeight = 1.1;

/** Contact points with their weights. */
struct WeightedPoints {
  std::span<const ContactPoint> contacts;
  std::array<double, 8> weights{};

  /** Returns the contact point with the greatest weighted `measure(p_WC)` above 0, or the
   number of contact points if there is none. */
  template <class Measure>
  std::size_t Greatest(const Measure& measure) const {
    std::size_t best = contacts.size();
    double greatest = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const double value = weights[k] * measure(contacts[k].p_WC);
      if (value <= greatest) continue;
      greatest = value;
      best = k;
    }
    return best;
  }

  /** Returns the contact point farthest from `p_W`; the first one if all are at `p_W`. */
  std::size_t Farthest(const Eigen::Vector3d& p_W) const {
    const std::size_t farthest =
        Greatest([&](const Eigen::Vector3d& p) { return (p - p_W).squaredNorm(); });
    return farthest < contacts.size() ? farthest : 0;
  }
};

}  // namespace

void ReduceManifold(std::span<const ContactPoint> before, Manifold& manifold) {
  if (manifold.count <= kContactsPerFace) return;
  WeightedPoints points{manifold.points()};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < points.contacts.size(); ++k) {
    const ContactPoint& contact = points.contacts[k];
    mean += contact.p_WC;
    const bool is_old = std::any_of(
        before.begin(), before.end(),
        [&](const ContactPoint& old) { return old.feature == contact.feature; });
    points.weights[k] = is_old ? kOldFeatureWeight : 1;
  }
  mean /= manifold.count;
  const std::size_t first = points.Farthest(mean);
  const Eigen::Vector3d start = points.contacts[first].p_WC;
  const std::size_t second = points.Farthest(start);
  const Eigen::Vector3d across =
      manifold.n_AB_W.cross(points.contacts[second].p_WC - start);
  const std::size_t left =
      points.Greatest([&](const Eigen::Vector3d& p) { return across.dot(p - start); });
  const std::size_t right =
      points.Greatest([&](const Eigen::Vector3d& p) { return -across.dot(p - start); });
  manifold.count = 0;
  for (std::size_t k = 0; k < points.contacts.size(); ++k) {
    if (k != first && k != second && k != left && k != right) continue;
    manifold.contacts[static_cast<std::size_t>(manifold.count++)] = points.contacts[k];
  }
}

}  // namespace cookbook
