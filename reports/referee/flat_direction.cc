#include "reports/referee/flat_direction.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/referee/support_feature.h"

namespace touchstone::referee {
namespace {

using Fine = DoubleDouble;

/** Returns R v with a relative error of at most some 2^-100. */
FineDirection Turned(const Eigen::Matrix3d& R, const Eigen::Vector3d& v) {
  const auto row = [&](int i) {
    return Fine(R(i, 0)) * Fine(v.x()) + Fine(R(i, 1)) * Fine(v.y()) +
           Fine(R(i, 2)) * Fine(v.z());
  };
  return {row(0), row(1), row(2)};
}

/** Returns the feature in the frame of `body`, where the corners are exact. */
SupportFeature FeatureInBody(const Body& body, const Eigen::Vector3d& n_W, double slack) {
  const Eigen::Vector3d n_B = body.X_WB.R_WB.transpose() * n_W;
  Body local{body.shape, {}};
  // The segment of a capsule, without the radius, which would be rounded.
  if (auto* const capsule = std::get_if<Capsule>(&local.shape)) capsule->radius = 0;
  return FeatureAlong(local, n_B, slack);
}

/** Appends the edges of the feature from its first corner. */
void AddEdges(const Body& body, const Eigen::Vector3d& n_W, double slack,
              std::vector<FineDirection>& edges) {
  const SupportFeature feature = FeatureInBody(body, n_W, slack);
  for (std::size_t i = 1; i < feature.points_W.size(); ++i) {
    edges.push_back(Turned(body.X_WB.R_WB, feature.points_W[i] - feature.points_W[0]));
  }
}

double Length(const FineDirection& v) {
  return std::hypot(v.x.hi(), v.y.hi(), v.z.hi());
}

/** Returns the one of `v` and −v that is nearer to n_W. */
FineDirection Towards(const Eigen::Vector3d& n_W, const FineDirection& v) {
  const FineDirection n = Exactly<Fine>(n_W);
  return Dot(n, v) < Fine(0) ? -v : v;
}

/** Returns the normal of the half-space `plane`, towards n_W. */
FineDirection NormalOf(const Body& plane, const Eigen::Vector3d& n_W) {
  const Eigen::Matrix3d& R = plane.X_WB.R_WB;
  return Towards(n_W, Cross(Exactly<Fine>(Eigen::Vector3d(R.col(0))),
                            Exactly<Fine>(Eigen::Vector3d(R.col(1)))));
}

}  // namespace

Eigen::Vector3d Rounded(const FineDirection& direction) {
  return Eigen::Vector3d(direction.x.hi(), direction.y.hi(), direction.z.hi())
      .normalized();
}

FineDirection FlatDirection(const ContactQuery& query, const Eigen::Vector3d& n_W,
                            double slack) {
  for (const Body* const body : {&query.A, &query.B}) {
    if (KindOf(body->shape) == ShapeKind::kHalfSpace) return NormalOf(*body, n_W);
  }
  std::vector<FineDirection> edges;
  AddEdges(query.A, n_W, slack, edges);
  AddEdges(query.B, -n_W, slack, edges);
  FineDirection n = Exactly<Fine>(n_W);
  const auto longest = std::ranges::max_element(edges, {}, Length);
  if (longest == edges.end() || Length(*longest) <= slack) return n;
  const FineDirection d = *longest;
  // The width of the plane that an edge spans with d.
  const auto width = [&](const FineDirection& edge) {
    return Length(Cross(d, edge)) / Length(d);
  };
  const auto widest = std::ranges::max_element(edges, {}, width);
  if (width(*widest) > slack) return Towards(n_W, Cross(d, *widest));
  return n - (Dot(n, d) / Dot(d, d)) * d;
}

bool IsTilted(const Body& body, const FineDirection& direction, double flush, double e) {
  const SupportFeature feature = FeatureInBody(body, Rounded(direction), e);
  const Fine length = sqrt(Dot(direction, direction));
  if (feature.is_disc) {
    // The disc is 2 % narrower than the polygon around it, whose corners are rounded.
    const double r = std::holds_alternative<Cone>(body.shape)
                         ? std::get<Cone>(body.shape).radius
                         : std::get<Cylinder>(body.shape).radius;
    const auto along = [&](int axis) {
      const FineDirection column =
          Exactly<Fine>(Eigen::Vector3d(body.X_WB.R_WB.col(axis)));
      return (Dot(direction, column) / length).hi();
    };
    return 2 * r * std::hypot(along(0), along(1)) > flush;
  }
  double least = 0;
  double most = 0;
  for (const Eigen::Vector3d& p : feature.points_W) {
    const FineDirection edge = Turned(body.X_WB.R_WB, p - feature.points_W[0]);
    const double height = (Dot(direction, edge) / length).hi();
    least = std::min(least, height);
    most = std::max(most, height);
  }
  return most - least > flush;
}

}  // namespace touchstone::referee
