#include "tests/reports/referee/hard_question.h"

#include <cmath>
#include <variant>

#include "reports/referee/referee.h"
#include "scenarios/cube_rotations.h"
#include "scenarios/generators/generate.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {
namespace {

void MoveTo(ContactQuery& query, double gap) {
  const ContactTruth truth = ComputeContactTruth(query);
  query.B.X_WB.p_WB += (gap - truth.separation.lo) * truth.certificate.n_AB_W;
}

/** Returns the number of whole 2^-10 of a power of two that is near `size`. [m] */
double Short(double size, double fraction) {
  const double unit = std::ldexp(1, std::ilogb(size) - 10);
  return unit * std::round(fraction * size / unit);
}

void MakeFlush(ContactQuery& query, RandomScene& random) {
  const double size = BoundingRadius(query.A.shape) + BoundingRadius(query.B.shape);
  query.A.X_WB = Pose::FromMatrix(Eigen::Vector3d::Zero(), query.A.X_WB.R_WB);
  const int axis = static_cast<int>(random.Uniform(0, 3));
  query.B.X_WB =
      Pose::FromMatrix(Short(size, random.Uniform(-1, 1)) * query.A.X_WB.R_WB.col(axis),
                       query.A.X_WB.R_WB);
  // Half of them touch, to the rounding of their coordinates.
  if (random.Uniform(0, 1) < 0.5) MoveTo(query, 0);
}

/** Returns the whole number of `unit` that is nearest to `length`, at least one. [m] */
double Whole(double length, double unit) {
  return unit * std::max(1.0, std::round(length / unit));
}

struct InUnits {
  double unit;

  Shape operator()(const Sphere& s) const { return Sphere{Whole(s.radius, unit)}; }
  Shape operator()(const Box& b) const {
    const Eigen::Vector3d& h = b.half_extents;
    return Box{{Whole(h.x(), unit), Whole(h.y(), unit), Whole(h.z(), unit)}};
  }
  Shape operator()(const Capsule& c) const {
    return Capsule{Whole(c.radius, unit), Whole(c.half_length, unit)};
  }
  Shape operator()(const Cylinder& c) const {
    return Cylinder{Whole(c.radius, unit), Whole(c.half_length, unit)};
  }
  Shape operator()(const Cone& c) const {
    return Cone{Whole(c.radius, unit), Whole(c.half_height, unit)};
  }
  Shape operator()(const ConvexHull& hull) const {
    ConvexHull whole = hull;
    for (Eigen::Vector3d& v : whole.vertices) v = unit * (v / unit).array().round();
    return whole;
  }
  Shape operator()(const HalfSpace& plane) const { return plane; }
};

/** Aligns a body with the axes of the world, `most` from the origin in each. */
void Align(Body& body, double unit, double most, RandomScene& random) {
  body.shape = std::visit(InUnits{unit}, body.shape);
  Eigen::Vector3d p_WB = random.Point(most);
  for (double& x : p_WB) x = random.Uniform(0, 1) < 0.4 ? 0 : unit * std::round(x / unit);
  const int turn = static_cast<int>(random.Uniform(0, kCubeRotations));
  body.X_WB = Pose::FromMatrix(p_WB, CubeRotation(turn));
}

void MakeAligned(ContactQuery& query, RandomScene& random) {
  const double size =
      std::max(BoundingRadius(query.A.shape), BoundingRadius(query.B.shape));
  const double unit = std::ldexp(1, std::ilogb(size) - 3);
  Align(query.A, unit, 0, random);
  Align(query.B, unit, 2 * size, random);
}

void Resize(Body& body, double factor) {
  body.shape = Resized(body.shape, factor);
  body.X_WB.p_WB *= factor;
}

void Harden(ContactQuery& query, std::size_t hardening, RandomScene& random) {
  switch (hardening) {
    case 1:
      return MoveTo(query,
                    random.Uniform(-1, 1) * random.Power(-17, -3) * SceneSize(query));
    case 2:
      return MakeFlush(query, random);
    case 3:
      return MakeAligned(query, random);
    case 4: {
      const double factor = random.Power(-30, 30);
      Resize(query.A, factor);
      Resize(query.B, factor);
      return;
    }
    case 5: {
      const Eigen::Vector3d far = random.Point(1) * random.Power(0, 8) * SceneSize(query);
      query.A.X_WB.p_WB += far;
      query.B.X_WB.p_WB += far;
      return;
    }
    case 6: {
      const Eigen::Vector3d p_AB_W = query.B.X_WB.p_WB - query.A.X_WB.p_WB;
      const double factor = random.Power(-6, 6);
      query.B.shape = Resized(query.B.shape, factor);
      query.B.X_WB.p_WB = query.A.X_WB.p_WB + std::max(1.0, factor) * p_AB_W;
      return;
    }
    default:
      return;
  }
}

}  // namespace

HardQuestion HardQuestionAt(std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kKinds = static_cast<std::uint64_t>(kShapeKinds);
  // The last pair would be that of two half-spaces.
  constexpr std::uint64_t kPairs = kKinds * kKinds - 1;
  // The later families have sizes and distances that the hardenings give too, and hulls
  // that are too large for a slow referee.
  std::vector<Family> families = AllFamilies();
  families.resize(static_cast<std::size_t>(Family::kSymmetries) + 1);
  const std::uint64_t pair = index % kPairs;
  const std::uint64_t family = index / kPairs % families.size();
  const std::uint64_t hardening = index / kPairs / families.size() % kHardenings.size();
  RandomScene random(seed * 1000003 + index);
  HardQuestion question{Generate(families[family], static_cast<ShapeKind>(pair / kKinds),
                                 static_cast<ShapeKind>(pair % kKinds), seed, index),
                        kHardenings[hardening]};
  Harden(question.query, hardening, random);
  return question;
}

}  // namespace touchstone
