#pragma once

#include <optional>

#include <Eigen/Core>

#include "scenarios/shape.h"

namespace touchstone {

/** The mass properties of a solid of uniform density. */
struct Solid {
  double volume;              ///< [m³]
  Eigen::Vector3d centre_B;   ///< Centre of mass, body frame. [m]
  Eigen::Matrix3d inertia_B;  ///< About the centre of mass, body axes. [kg m²]
};

/** Largest distance of the centre of mass from the origin, over the size of the shape,
 and largest product of inertia, over the largest moment, of a body whose moments along
 its axes describe it: vertices of a file are rounded. [-] */
inline constexpr double kAligned = 1e-9;

/** Returns `shape` filled uniformly with `mass` [kg]: closed forms, and for a hull the
 integrals over the tetrahedra between its faces and a point inside, exact but for
 rounding. Nothing for a half-space or a hull without volume. */
std::optional<Solid> UniformSolid(const Shape& shape, double mass);

/** Returns the moments of inertia of UniformSolid() along the body axes. Nothing unless
 its centre of mass is the origin and its principal axes are the body axes, to kAligned:
 never for a cone, whose centre of mass is a quarter of its height above its base.
 [kg m²] */
std::optional<Eigen::Vector3d> UniformMoments(const Shape& shape, double mass);

}  // namespace touchstone
