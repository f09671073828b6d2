#include "reports/shrink/size.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace touchstone {
namespace {

int LengthOf(double x) {
  if (x == 0) return 0;
  if (x == 1) return 1;
  return 1 + static_cast<int>(fmt::formatted_size("{}", x));
}

int DecadesOf(double x) {
  if (x == 0) return 0;
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(x))));
  return exponent < -1 ? -1 - exponent : std::max(exponent, 0);
}

int LengthOfRotation(const Pose& X_WB) {
  // A quaternion that is left out of a file is the identity; a matrix is always written.
  if (X_WB.R_WB == Eigen::Matrix3d::Identity()) return X_WB.q_WB ? 0 : 1;
  int length = 2;
  if (X_WB.q_WB) {
    for (const double x : X_WB.q_WB->coeffs()) length += LengthOf(x);
  } else {
    for (const double x : X_WB.R_WB.reshaped()) length += LengthOf(x);
  }
  return length;
}

// A half-space is simpler than a sphere for a reader, but no reduction makes one.
int RankOf(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kHalfSpace:
      return 0;
    case ShapeKind::kSphere:
      return 1;
    case ShapeKind::kBox:
      return 2;
    case ShapeKind::kCapsule:
      return 3;
    case ShapeKind::kCylinder:
      return 4;
    case ShapeKind::kCone:
      return 5;
    case ShapeKind::kConvexHull:
      return 6;
  }
  return 6;
}

void AddWorld(const WorldScenario& scenario, Size& size) {
  const World& world = scenario.world;
  size.parts = static_cast<int>(world.bodies.size() + world.particles.size() +
                                world.springs.size() + world.joints.size() +
                                world.cloths.size() + world.pushes.size());
  size.claims = static_cast<int>(scenario.claims.size() + scenario.expectations.size()) +
                (scenario.ensemble ? 1 : 0) + (scenario.horizon ? 1 : 0);
  size.steps = world.steps;
  size.samples = world.steps / world.sample_every;
}

}  // namespace

Size SizeOf(const Question& question) {
  Size size;
  if (const auto* const world = std::get_if<WorldScenario>(&question))
    AddWorld(*world, size);
  std::set<double> different;
  for (const Body* const body : BodiesOf(question)) {
    size.shapes += RankOf(KindOf(body->shape));
    size.rotations += LengthOfRotation(body->X_WB);
    if (const auto* const hull = std::get_if<ConvexHull>(&body->shape)) {
      size.vertices += static_cast<int>(hull->vertices.size());
      for (const Eigen::Vector3d& vertex : hull->vertices)
        different.insert(vertex.begin(), vertex.end());
    }
    Shape shape = body->shape;
    for (const double* const length : SizesOf(shape)) {
      different.insert(*length);
      size.decades += DecadesOf(*length);
    }
    size.decades += DecadesOf(body->X_WB.p_WB.norm());
  }
  size.different = static_cast<int>(different.size());
  Question copy = question;
  for (const double* const number : NumbersOf(copy)) size.digits += LengthOf(*number);
  return size;
}

}  // namespace touchstone
