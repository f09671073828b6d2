#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"

struct dxGeom;  // What ODE's dGeomID points to.

namespace touchstone {

/** A posed ODE geom in no space, with the arrays that a convex geom only points to. */
class OdeGeom {
 public:
  /** Makes the geom for `body`, or an empty one where ODE has no such shape: a cone, or a
   convex hull without volume. */
  explicit OdeGeom(const Body& body);

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
  Eigen::Vector3d origin_B_ = Eigen::Vector3d::Zero();  // Of the geom, in the body. [m]
  std::unique_ptr<dxGeom, Destroy> geom_;
};

}  // namespace touchstone
