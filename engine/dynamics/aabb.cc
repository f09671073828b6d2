#include "engine/dynamics/aabb.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/** Returns a float that is not less, by a few roundings more at most; of what is beyond
 them the last, so that all of the world does not overlap Nothing(). */
float RoundedUp(double x) {
  using Limits = std::numeric_limits<float>;
  const double kept =
      std::min<double>(std::max<double>(x, Limits::lowest()), Limits::max());
  const auto near = static_cast<float>(kept);
  if (near >= kept) return near;
  return near + (std::abs(near) * Limits::epsilon() + Limits::min());
}

}  // namespace

LooseBox LooseBox::Around(const Aabb& box) {
  const Eigen::Vector3d& high = box.high;
  const Eigen::Vector3d low = -box.low;
  const Corner down = {RoundedUp(low[0]), RoundedUp(low[1]), RoundedUp(low[2])};
  return {-down, Corner{RoundedUp(high[0]), RoundedUp(high[1]), RoundedUp(high[2])}};
}

LooseBox LooseBox::Nothing() {
  const Corner far = {kInfinity, kInfinity, kInfinity};
  return {far, -far};
}

}  // namespace cookbook
