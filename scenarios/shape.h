#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** A ball centred on the body origin. */
struct Sphere {
  double radius;  ///< [m], > 0
};

/** A rectangular solid centred on the body origin, edges along the body axes. */
struct Box {
  Eigen::Vector3d half_extents;  ///< [m], each > 0
};

/** All points within `radius` of a segment on the body's z axis that is centred on the
 body origin. */
struct Capsule {
  double radius;       ///< [m], > 0
  double half_length;  ///< Half the length of the segment, without caps. [m], > 0
};

/** A right circular cylinder about the body's z axis, centred on the body origin. */
struct Cylinder {
  double radius;       ///< [m], > 0
  double half_length;  ///< [m], > 0
};

/** A right circular cone about the body's z axis: apex at z = +half_height, base disc at
 z = -half_height. */
struct Cone {
  double radius;       ///< Radius of the base. [m], > 0
  double half_height;  ///< [m], > 0
};

/** The convex hull of its vertices; interior and coplanar vertices are legal. */
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;  ///< Body frame; at least one. [m]
};

/** The unbounded solid {x : z <= 0} in its body frame; its outward normal is +z. */
struct HalfSpace {};

/** The closed set of shapes. A new alternative breaks every std::visit until each adapter
 either handles it or returns `unsupported`; this is intended. */
using Shape = std::variant<Sphere, Box, Capsule, Cylinder, Cone, ConvexHull, HalfSpace>;

/** The kinds of shape, in the order of the alternatives of Shape. */
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

/** Returns the radius of the smallest ball about the body origin that contains `shape`.
 For a half-space: 0, since only its boundary has a position. [m] */
double BoundingRadius(const Shape& shape);

/** Returns `shape` with every size multiplied by `factor`; a half-space is unchanged.
 @pre factor > 0. */
Shape Resized(const Shape& shape, double factor);

}  // namespace touchstone
