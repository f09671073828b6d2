#include "tests/scenarios/same_bits.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace touchstone {
namespace {

bool Same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class Derived>
bool Same(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!Same(a(i % a.rows(), i / a.rows()), b(i % a.rows(), i / a.rows()))) return false;
  }
  return true;
}

bool Same(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const Eigen::Vector3d& v, const Eigen::Vector3d& w) { return Same(v, w); });
}

struct SameShape {
  bool operator()(const Sphere& a, const Sphere& b) const {
    return Same(a.radius, b.radius);
  }
  bool operator()(const Box& a, const Box& b) const {
    return Same(a.half_extents, b.half_extents);
  }
  bool operator()(const Capsule& a, const Capsule& b) const {
    return Same(a.radius, b.radius) && Same(a.half_length, b.half_length);
  }
  bool operator()(const Cylinder& a, const Cylinder& b) const {
    return Same(a.radius, b.radius) && Same(a.half_length, b.half_length);
  }
  bool operator()(const Cone& a, const Cone& b) const {
    return Same(a.radius, b.radius) && Same(a.half_height, b.half_height);
  }
  bool operator()(const ConvexHull& a, const ConvexHull& b) const {
    return Same(a.vertices, b.vertices);
  }
  bool operator()(const HalfSpace&, const HalfSpace&) const { return true; }
  template <class A, class B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

bool Same(const Body& a, const Body& b) {
  const std::optional<Eigen::Quaterniond>& q = a.X_WB.q_WB;
  const std::optional<Eigen::Quaterniond>& r = b.X_WB.q_WB;
  return std::visit(SameShape{}, a.shape, b.shape) && Same(a.X_WB.p_WB, b.X_WB.p_WB) &&
         Same(a.X_WB.R_WB, b.X_WB.R_WB) && q.has_value() == r.has_value() &&
         (!q || Same(q->coeffs(), r->coeffs()));
}

bool Same(const ContactExpectation& a, const ContactExpectation& b) {
  return a.touching == b.touching &&
         a.separation.has_value() == b.separation.has_value() &&
         (!a.separation || Same(*a.separation, *b.separation)) &&
         Same(a.normals, b.normals) && a.contacts == b.contacts;
}

bool Same(const std::optional<ToleranceOverride>& a,
          const std::optional<ToleranceOverride>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return Same(a->separation, b->separation) && a->because == b->because;
}

bool Same(const std::vector<Indictment>& a, const std::vector<Indictment>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Indictment& i, const Indictment& j) {
                      return i.oracle == j.oracle && i.anomaly == j.anomaly &&
                             i.reproduces == j.reproduces;
                    });
}

}  // namespace

bool SameBits(const ContactQuery& a, const ContactQuery& b) {
  return Same(a.A, b.A) && Same(a.B, b.B);
}

bool SameBits(const Scenario& a, const Scenario& b) {
  return a.id == b.id && a.title == b.title && a.source == b.source &&
         a.name_A == b.name_A && a.name_B == b.name_B && SameBits(a.contact, b.contact) &&
         Same(a.expect, b.expect) && Same(a.tolerance, b.tolerance) &&
         Same(a.indicts, b.indicts);
}

}  // namespace touchstone
