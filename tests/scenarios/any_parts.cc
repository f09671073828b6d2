#include "tests/scenarios/any_parts.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include <rapidcheck.h>

#include "scenarios/validate.h"

namespace touchstone {

double AnyNumber() {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  // RapidCheck's integers grow with the size of the test, so their bits are mixed to
  // reach every exponent.
  const auto value = std::bit_cast<double>(bits * 0x9e3779b97f4a7c15U);
  const double special =
      *rc::gen::element(-0.0, 0.1, 5e-324, 1e16, 0x1.fffffffffffffp1023);
  return std::isfinite(value) && *rc::gen::inRange(0, 4) != 0 ? value : special;
}

double AnyLength() {
  const double value = std::abs(AnyNumber());
  return value >= kShortest && value <= kLongest ? value : 1.0 / 3;
}

Eigen::Vector3d AnyPoint() {
  return {AnyNumber(), AnyNumber(), AnyNumber()};
}

namespace {

double AnyCoordinate() {
  const double value = AnyNumber();
  const bool in_range = std::abs(value) >= kShortest && std::abs(value) <= kLongest;
  return in_range ? value : *rc::gen::element(0.0, -0.0, 0.1, 1e-100, -1e100);
}

}  // namespace

Eigen::Vector3d AnyPlace() {
  return {AnyCoordinate(), AnyCoordinate(), AnyCoordinate()};
}

double AnyComponent() {
  return *rc::gen::inRange(-1000, 1000) / 997.0;
}

std::string AnyText() {
  const std::string text =
      *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::map(
          rc::gen::inRange(0, 128), [](int c) { return static_cast<char>(c); })));
  return *rc::gen::element<std::string>("", "π ≈ 3", "\"\"\"", "\\u0041",
                                        "# no comment") +
         text;
}

std::vector<MeasureKind> AnyMeasures() {
  return *rc::gen::nonEmpty(
      rc::gen::container<std::vector<MeasureKind>>(rc::gen::elementOf(AllMeasures())));
}

Pose AnyPose() {
  const Eigen::Vector4d wxyz(AnyComponent(), AnyComponent(), AnyComponent(), 0.1);
  const Eigen::Quaterniond q_WB(wxyz.normalized());
  if (*rc::gen::arbitrary<bool>()) return Pose::FromQuaternion(AnyPlace(), q_WB);
  return Pose::FromMatrix(AnyPlace(), q_WB.toRotationMatrix());
}

Shape AnyShape(bool bounded) {
  // At full size, since RapidCheck's small tests would rarely go beyond the first kinds.
  switch (static_cast<ShapeKind>(*rc::gen::resize(
      rc::kNominalSize, rc::gen::inRange(0, kShapeKinds - (bounded ? 1 : 0))))) {
    case ShapeKind::kSphere:
      return Sphere{AnyLength()};
    case ShapeKind::kBox:
      return Box{{AnyLength(), AnyLength(), AnyLength()}};
    case ShapeKind::kCapsule:
      return Capsule{AnyLength(), AnyLength()};
    case ShapeKind::kCylinder:
      return Cylinder{AnyLength(), AnyLength()};
    case ShapeKind::kCone:
      return Cone{AnyLength(), AnyLength()};
    case ShapeKind::kConvexHull: {
      ConvexHull hull;
      const int vertices = *rc::gen::inRange(1, 9);
      for (int i = 0; i < vertices; ++i) hull.vertices.push_back(AnyPlace());
      return hull;
    }
    case ShapeKind::kHalfSpace:
      return HalfSpace{};
  }
  return HalfSpace{};
}

}  // namespace touchstone
