#include "scenarios/generators/feature.h"

#include <algorithm>
#include <array>

#include "scenarios/generators/hull_facets.h"
#include "scenarios/generators/portable_math.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

/** Returns a weight of a normal in a normal cone. It is never small, so that the sum
 stays away from the cone's border. */
double Weight(Random& random) {
  return random.Uniform(0.2, 1);
}

/** Returns a position along an edge of half length 1, away from its ends. */
double Along(Random& random) {
  return random.Uniform(-0.8, 0.8);
}

Vector3d Radial(Random& random) {
  const Eigen::Vector2d u = random.PlaneDirection();
  return {u.x(), u.y(), 0};
}

struct FeatureOf {
  FeatureKind kind;
  Random& random;

  Feature operator()(const Sphere& sphere) const {
    const Vector3d n = random.Direction();
    return {sphere.radius * n, n};
  }

  Feature operator()(const Box& box) const {
    // A vertex fixes all three coordinates at a face, an edge two, a face one.
    const int first = random.Below(3);
    const int held = kind == FeatureKind::kVertex ? 3
                     : kind == FeatureKind::kEdge ? 2
                                                  : 1;
    Vector3d p, n = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      const int axis = (first + i) % 3;
      if (i < held) {
        const double sign = random.Sign();
        p[axis] = sign * box.half_extents[axis];
        n[axis] = held == 1 ? sign : sign * Weight(random);
      } else {
        p[axis] = Along(random) * box.half_extents[axis];
      }
    }
    return {p, Unit(n)};
  }

  Feature operator()(const Capsule& capsule) const {
    const double z = Along(random) * capsule.half_length;
    const Vector3d radial = Radial(random);
    if (kind != FeatureKind::kVertex) {
      return {capsule.radius * radial + z * Vector3d::UnitZ(), radial};
    }
    const Vector3d n = random.Direction();
    const double end = n.z() < 0 ? -capsule.half_length : capsule.half_length;
    return {capsule.radius * n + end * Vector3d::UnitZ(), n};
  }

  Feature operator()(const Cylinder& cylinder) const {
    const double end = random.Sign();
    const Vector3d radial = Radial(random);
    const Vector3d z = Vector3d::UnitZ();
    if (kind == FeatureKind::kFace) {
      const double place = Along(random);
      if (random.Coin()) {
        return {place * cylinder.radius * radial + end * cylinder.half_length * z,
                end * z};
      }
      return {cylinder.radius * radial + place * cylinder.half_length * z, radial};
    }
    const double axial_weight = Weight(random);
    const double radial_weight = Weight(random);
    return {cylinder.radius * radial + end * cylinder.half_length * z,
            Unit(axial_weight * end * z + radial_weight * radial)};
  }

  Feature operator()(const Cone& cone) const {
    const Vector3d radial = Radial(random);
    const Vector3d z = Vector3d::UnitZ();
    const Vector3d apex = cone.half_height * z;
    const Vector3d rim = cone.radius * radial - cone.half_height * z;
    const Vector3d lateral = Unit(2 * cone.half_height * radial + cone.radius * z);
    const double one = Weight(random);
    const double other = Weight(random);
    if (kind == FeatureKind::kVertex) return {apex, Unit(one * z + other * lateral)};
    if (kind == FeatureKind::kEdge) return {rim, Unit(one * lateral - other * z)};
    const double place = random.Uniform(0.1, 0.9);
    if (random.Coin()) return {apex + place * (rim - apex), lateral};
    return {place * cone.radius * radial - cone.half_height * z, -z};
  }

  Feature operator()(const ConvexHull& hull) const {
    const std::vector<Facet> facets = FacetsOf(hull);
    const Facet& facet =
        facets[static_cast<std::size_t>(random.Below(static_cast<int>(facets.size())))];
    // The corners of the feature: 3, 2 or 1 corners of the facet from a random start.
    const auto turn = static_cast<std::size_t>(random.Below(3));
    const std::size_t corners = kind == FeatureKind::kVertex ? 1
                                : kind == FeatureKind::kEdge ? 2
                                                             : 3;
    Vector3d p = Vector3d::Zero();
    double sum = 0;
    std::array<std::size_t, 3> indices;
    for (std::size_t i = 0; i < corners; ++i) {
      indices[i] = facet.vertices[(turn + i) % 3];
      const double weight = Weight(random);
      p += weight * hull.vertices[indices[i]];
      sum += weight;
    }
    // The normals of the facets that have all of these corners span its normal cone.
    Vector3d n = Vector3d::Zero();
    for (const Facet& other : facets) {
      const bool has_all = std::all_of(
          indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(corners),
          [&](std::size_t index) {
            return std::find(other.vertices.begin(), other.vertices.end(), index) !=
                   other.vertices.end();
          });
      if (has_all) n += Weight(random) * other.n_B;
    }
    return {corners == 1 ? hull.vertices[indices[0]] : Vector3d(p / sum),
            corners == 3 ? facet.n_B : Unit(n)};
  }

  Feature operator()(const HalfSpace&) const {
    const double x = random.Uniform(-3, 3);
    const double y = random.Uniform(-3, 3);
    return {{x, y, 0}, Vector3d::UnitZ()};
  }
};

}  // namespace

Feature RandomFeature(const Shape& shape, FeatureKind kind, Random& random) {
  return std::visit(FeatureOf{kind, random}, shape);
}

}  // namespace touchstone
