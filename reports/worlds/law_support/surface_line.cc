#include "reports/worlds/law_support/surface_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

namespace touchstone {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** Returns the part of p + t d where |coordinate| is at most `half`. */
std::optional<Chord> ThroughSlab(double p, double d, double half) {
  if (half < 0) return std::nullopt;
  if (d == 0) {
    if (std::abs(p) > half) return std::nullopt;
    return Chord{-kInfinity, kInfinity};
  }
  const double first = (-half - p) / d;
  const double last = (half - p) / d;
  return Chord{std::min(first, last), std::max(first, last)};
}

std::optional<Chord> Through(const Sphere& sphere, double offset,
                             const Eigen::Vector3d& p, const Eigen::Vector3d& d) {
  const double radius = sphere.radius + offset;
  const double middle = -p.dot(d);
  const double beside = (p + middle * d).norm();
  if (radius < 0 || beside > radius) return std::nullopt;
  // Not √(r² − b²), which cancels where the line grazes.
  const double half = std::sqrt((radius - beside) * (radius + beside));
  return Chord{middle - half, middle + half};
}

std::optional<Chord> Through(const Box& box, double offset, const Eigen::Vector3d& p,
                             const Eigen::Vector3d& d) {
  Chord chord{-kInfinity, kInfinity};
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto slab = ThroughSlab(p[i], d[i], box.half_extents[i] + offset);
    if (!slab) return std::nullopt;
    chord.enters = std::max(chord.enters, slab->enters);
    chord.leaves = std::min(chord.leaves, slab->leaves);
  }
  if (chord.enters > chord.leaves) return std::nullopt;
  return chord;
}

std::optional<Chord> Through(const HalfSpace&, double offset, const Eigen::Vector3d& p,
                             const Eigen::Vector3d& d) {
  const double outside = p.z() - offset;
  if (d.z() == 0) {
    if (outside > 0) return std::nullopt;
    return Chord{-kInfinity, kInfinity};
  }
  const double crosses = -outside / d.z();
  return d.z() > 0 ? Chord{-kInfinity, crosses} : Chord{crosses, kInfinity};
}

template <class T>
constexpr bool kHasChords =
    std::is_same_v<T, Sphere> || std::is_same_v<T, Box> || std::is_same_v<T, HalfSpace>;

}  // namespace

bool HasChords(const Shape& shape) {
  return std::visit([]<class T>(const T&) { return kHasChords<T>; }, shape);
}

BodyLine SeenFrom(const Pose& X_WB, const Eigen::Vector3d& p_W,
                  const Eigen::Vector3d& d_W) {
  return {X_WB.R_WB.transpose() * (p_W - X_WB.p_WB), X_WB.R_WB.transpose() * d_W};
}

std::optional<Chord> ChordThrough(const Shape& shape, double offset,
                                  const BodyLine& line) {
  return std::visit(
      [&]<class T>(const T& known) -> std::optional<Chord> {
        if constexpr (kHasChords<T>) {
          return Through(known, offset, line.p_Bo, line.d_B);
        } else {
          return std::nullopt;
        }
      },
      shape);
}

std::optional<Chord> ChordThrough(const Body& body, double offset,
                                  const Eigen::Vector3d& p_W,
                                  const Eigen::Vector3d& d_W) {
  return ChordThrough(body.shape, offset, SeenFrom(body.X_WB, p_W, d_W));
}

}  // namespace touchstone
