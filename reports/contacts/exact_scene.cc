#include "reports/contacts/exact_scene.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace touchstone {
namespace {

void Add(const Eigen::Vector3d& v, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
}

/** Appends the sizes of a shape. */
struct AddSizes {
  std::vector<double>& numbers;

  void operator()(const Sphere& s) const { numbers.push_back(s.radius); }
  void operator()(const Box& s) const { Add(s.half_extents, numbers); }
  void operator()(const Capsule& s) const {
    numbers.insert(numbers.end(), {s.radius, s.half_length});
  }
  void operator()(const Cylinder& s) const {
    numbers.insert(numbers.end(), {s.radius, s.half_length});
  }
  void operator()(const Cone& s) const {
    numbers.insert(numbers.end(), {s.radius, s.half_height});
  }
  void operator()(const ConvexHull& s) const {
    for (const Eigen::Vector3d& v : s.vertices) Add(v, numbers);
  }
  void operator()(const HalfSpace&) const {}
};

bool MapsAxesToAxes(const Eigen::Matrix3d& R) {
  return (R.array() == 0 || R.array().abs() == 1).all() && R.array().abs().sum() == 3;
}

/** Returns the exponent of the last set bit of `x`, which is not 0. */
int LastBit(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  auto integer = static_cast<long long>(std::ldexp(std::abs(mantissa), 53));
  exponent -= 53;
  for (; integer % 2 == 0; integer /= 2) ++exponent;
  return exponent;
}

}  // namespace

bool IsExactScene(const ContactQuery& query, double u) {
  std::vector<double> numbers;
  for (const Body* body : {&query.A, &query.B}) {
    if (!MapsAxesToAxes(body->X_WB.R_WB)) return false;
    Add(body->X_WB.p_WB, numbers);
    std::visit(AddSizes{numbers}, body->shape);
  }
  std::erase(numbers, 0.0);
  if (numbers.empty()) return true;
  int last = LastBit(numbers.front());
  int first = std::ilogb(numbers.front());
  for (const double x : numbers) {
    last = std::min(last, LastBit(x));
    first = std::max(first, std::ilogb(x));
  }
  // A coordinate of a corner is a sum of two numbers, its square has twice their bits,
  // and a sum of three squares two more: 2 (bits + 1) + 2 <= the bits of a mantissa.
  const int bits = first - last + 1;
  return 2 * (bits + 1) + 2 <= static_cast<int>(-std::log2(u));
}

std::optional<bool> TouchingInExactScene(const ContactQuery& query,
                                         const ContactTruth& truth) {
  const double none = 0x1p-200 * SceneSize(query);
  if (truth.separation.hi <= none && truth.separation.lo >= -none) return true;
  if (truth.separation.lo > 0) return false;
  if (truth.separation.hi <= 0) return true;
  return std::nullopt;
}

}  // namespace touchstone
