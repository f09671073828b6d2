#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"

// ODE's dGeomID and dBodyID are pointers to these.
struct dxGeom;
struct dxBody;

namespace touchstone {

/** Why ODE has no geom for a convex hull in a plane. */
inline constexpr const char* kNoFlatHull = "ODE requires convex hulls with volume";

/** An ODE geom with a pose, outside any space. It owns the arrays of a convex geom, which
 stores only pointers to them. */
class OdeGeom {
 public:
  /** Creates the geom for `body`, or an empty one if ODE has no such shape: a cone, or a
   convex hull without volume. */
  explicit OdeGeom(const Body& body);

  /** Hangs it on a body of ODE, which then moves it: the geom keeps its pose relative to
   the frame of the shape. */
  void AttachTo(dxBody* body);

  dxGeom* get() const { return geom_.get(); }
  explicit operator bool() const { return geom_ != nullptr; }

 private:
  struct Destroy {
    void operator()(dxGeom* geom) const;
  };

  void MakeConvex(const ConvexHull& hull);

  std::vector<double> planes_;
  std::vector<double> points_;
  std::vector<unsigned> polygons_;
  Eigen::Vector3d origin_B_ = Eigen::Vector3d::Zero();  // Geom origin, body frame. [m]
  std::unique_ptr<dxGeom, Destroy> geom_;
};

}  // namespace touchstone
