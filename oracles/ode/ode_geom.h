#pragma once

#include <memory>
#include <type_traits>
#include <vector>

#include <ode/ode.h>

#include "scenarios/contact_query.h"

namespace touchstone {

/** A posed ODE geom in no space, with the arrays that a convex geom only points to. */
class OdeGeom {
 public:
  /** Makes the geom for `body`, or an empty one where ODE has no such shape: a cone, or a
   convex hull without volume. */
  explicit OdeGeom(const Body& body);

  dGeomID get() const { return geom_.get(); }
  explicit operator bool() const { return geom_ != nullptr; }

 private:
  struct Destroy {
    void operator()(dGeomID geom) const { dGeomDestroy(geom); }
  };

  void MakeConvex(const ConvexHull& hull);

  std::vector<dReal> planes_;
  std::vector<dReal> points_;
  std::vector<unsigned> polygons_;
  Eigen::Vector3d origin_B_ = Eigen::Vector3d::Zero();  // Of the geom, in the body. [m]
  std::unique_ptr<std::remove_pointer_t<dGeomID>, Destroy> geom_;
};

}  // namespace touchstone
