#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** A ball centred on its body origin. */
struct Sphere {
  double radius;  ///< [m], > 0
};

/** A rectangular solid centred on its body origin, edges along the body axes. */
struct Box {
  Eigen::Vector3d half_extents;  ///< [m], each > 0
};

/** All points within `radius` of a segment on the body's z axis, centred on the origin.
 */
struct Capsule {
  double radius;       ///< [m], > 0
  double half_length;  ///< Half the segment, without the caps. [m], > 0
};

/** A right circular cylinder about the body's z axis, centred on its origin. */
struct Cylinder {
  double radius;       ///< [m], > 0
  double half_length;  ///< [m], > 0
};

/** A right circular cone about the body's z axis: apex at z = +half_height, base disc at
 z = -half_height. */
struct Cone {
  double radius;       ///< Of the base. [m], > 0
  double half_height;  ///< [m], > 0
};

/** The convex hull of its vertices; interior and coplanar vertices are legal. */
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;  ///< Body frame, [m]; at least one.
};

/** The unbounded solid {x : z <= 0} in its body frame; its outward normal is +z. */
struct HalfSpace {};

/** The closed set of shapes. Adding one breaks every std::visit until each adapter either
 answers for it or says `unsupported`, which is the intent. */
using Shape = std::variant<Sphere, Box, Capsule, Cylinder, Cone, ConvexHull, HalfSpace>;

/** The kinds of shape, in the order of Shape's alternatives. */
enum class ShapeKind {
  kSphere,
  kBox,
  kCapsule,
  kCylinder,
  kCone,
  kConvexHull,
  kHalfSpace
};

inline constexpr int kShapeKinds = static_cast<int>(std::variant_size_v<Shape>);

/** Returns the kind of `shape`. */
ShapeKind KindOf(const Shape& shape);

/** Returns the name used in files and tables: "sphere", "box", "capsule", "cylinder",
 "cone", "convex_hull", "half_space". */
std::string_view NameOf(ShapeKind kind);

/** Returns the radius of the smallest origin-centred ball that holds `shape`. [m]
 For a half-space: 0, its boundary being all that has a place. */
double BoundingRadius(const Shape& shape);

/** Returns `shape` with every size multiplied by `factor`; a half-space has none.
 @pre factor > 0. */
Shape Resized(const Shape& shape, double factor);

}  // namespace touchstone
