#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/referee/flat_direction.h"
#include "reports/referee/planar_intersection.h"
#include "reports/referee/referee.h"
#include "reports/referee/support_feature.h"

namespace touchstone {
namespace {

using namespace referee;

/** Coordinates in the plane perpendicular to a normal, with an origin near the features.
 */
class Plane {
 public:
  Plane(const Eigen::Vector3d& n, const Eigen::Vector3d& origin)
      : n_(n), origin_(origin) {
    Eigen::Index least;
    n.cwiseAbs().minCoeff(&least);
    u_ = n.cross(Eigen::Vector3d::Unit(least)).normalized();
    v_ = n.cross(u_);
  }
  Eigen::Vector2d Project(const Eigen::Vector3d& p) const {
    return {u_.dot(p - origin_), v_.dot(p - origin_)};
  }
  /** Returns the point over `p` at `height` above the origin along the normal. */
  Eigen::Vector3d Lift(const Eigen::Vector2d& p, double height) const {
    return origin_ + p.x() * u_ + p.y() * v_ + height * n_;
  }

 private:
  Eigen::Vector3d n_, origin_, u_, v_;
};

std::vector<Eigen::Vector2d> Project(const Plane& plane,
                                     const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector2d> projected;
  projected.reserve(points.size());
  for (const Eigen::Vector3d& p : points) projected.push_back(plane.Project(p));
  return projected;
}

double Farthest(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& n,
                const Eigen::Vector3d& origin) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p : points) most = std::max(most, n.dot(p - origin));
  return most;
}

double Extent(const Polygon& polygon) {
  double most = 0;
  for (const Eigen::Vector2d& p : polygon) most = std::max(most, (p - polygon[0]).norm());
  return most;
}

bool Same(const Polygon& P, const Polygon& Q, double slack) {
  return P.size() == Q.size() && std::all_of(P.begin(), P.end(), [&](const auto& p) {
           return std::any_of(Q.begin(), Q.end(),
                              [&](const auto& q) { return (p - q).norm() <= 4 * slack; });
         });
}

/** Returns the position of a bounded body of `query`. [m] */
Eigen::Vector3d OriginOf(const ContactQuery& query) {
  const bool plane_is_A = KindOf(query.A.shape) == ShapeKind::kHalfSpace;
  return plane_is_A ? query.B.X_WB.p_WB : query.A.X_WB.p_WB;
}

/** Returns `query` moved by −`origin`. Far from the world's origin its features are then
 not rounded like their coordinates there. */
ContactQuery About(const Eigen::Vector3d& origin, const ContactQuery& query) {
  ContactQuery moved = query;
  moved.A.X_WB.p_WB -= origin;
  moved.B.X_WB.p_WB -= origin;
  return moved;
}

ContactPatch MovedBy(const Eigen::Vector3d& origin, ContactPatch patch) {
  for (Eigen::Vector3d& p : patch.vertices_W) p += origin;
  return patch;
}

/** Returns the rounding of a feature. Transforming and projecting the corners costs a few
 roundings of the scene. [m] */
double FeatureRounding(const ContactQuery& query) {
  return 32 * std::numeric_limits<double>::epsilon() * SceneSize(query);
}

/** Returns PatchAlong() of a query about its own origin.
 @pre `n` is a unit vector. */
ContactPatch LocalPatch(const ContactQuery& query, const Eigen::Vector3d& n,
                        double separation, double slack) {
  const double rounding = slack + FeatureRounding(query);
  const SupportFeature A = FeatureAlong(query.A, n, rounding);
  const SupportFeature B = FeatureAlong(query.B, -n, rounding);

  const Eigen::Vector3d origin = A.is_plane ? B.points_W[0] : A.points_W[0];
  const Plane plane(n, origin);
  // The plane midway through the overlap: half the overlap back from the front of A,
  // which is as far beyond the back of B.
  const double middle = A.is_plane ? -Farthest(B.points_W, -n, origin) - separation / 2
                                   : Farthest(A.points_W, n, origin) + separation / 2;

  const Polygon P = HullOf(Project(plane, A.points_W), rounding);
  const Polygon Q = HullOf(Project(plane, B.points_W), rounding);
  Polygon patch;
  if (A.is_plane || B.is_plane) {
    patch = A.is_plane ? Q : P;
  } else {
    // A round body displaced sideways by w is lower by only w²/2R.
    const double parallel = std::sqrt(2 * rounding * std::max(Extent(P), Extent(Q)));
    patch = Intersect(P, Q, rounding, parallel);
  }

  ContactPatch result;
  for (const Eigen::Vector2d& p : patch)
    result.vertices_W.push_back(plane.Lift(p, middle));
  const bool whole_disc =
      (A.is_disc && Same(patch, P, rounding)) || (B.is_disc && Same(patch, Q, rounding));
  result.least_contacts = whole_disc ? 3 : std::min(static_cast<int>(patch.size()), 4);
  return result;
}

}  // namespace

ContactPatch PatchAlong(const ContactQuery& query, const Eigen::Vector3d& n_W,
                        double separation, double slack) {
  const Eigen::Vector3d origin = OriginOf(query);
  return MovedBy(origin,
                 LocalPatch(About(origin, query), n_W.normalized(), separation, slack));
}

ContactPatch CertainPatch(const ContactQuery& query, const Eigen::Vector3d& n_W,
                          double separation, double flush, double e) {
  const Eigen::Vector3d origin = OriginOf(query);
  const ContactQuery local = About(origin, query);
  const FineDirection direction = FlatDirection(local, n_W.normalized(), e);
  const Eigen::Vector3d n = Rounded(direction);
  ContactPatch patch = LocalPatch(local, n, separation, flush);
  // What LocalPatch() takes for flat must be flat to within `flush`.
  const double nearly = std::max(e, flush + FeatureRounding(local));
  if (IsTilted(local.A, direction, flush, nearly) ||
      IsTilted(local.B, -direction, flush, nearly)) {
    patch.vertices_W.resize(1);
    patch.least_contacts = 1;
  }
  const Plane plane(n, patch.vertices_W.front());
  ContactPatch certain;
  for (const Eigen::Vector2d& p : HullOf(Project(plane, patch.vertices_W), kBlurred * e))
    certain.vertices_W.push_back(plane.Lift(p, 0));
  certain.least_contacts =
      std::min(patch.least_contacts, static_cast<int>(certain.vertices_W.size()));
  return MovedBy(origin, certain);
}

}  // namespace touchstone
