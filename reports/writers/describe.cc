#include "reports/writers/describe.h"

#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "reports/contacts/exact_scene.h"
#include "reports/text/counted.h"
#include "reports/text/format_vector.h"

namespace touchstone {
namespace {

struct DescribeShape {
  std::string operator()(const Sphere& s) const {
    return fmt::format("sphere, radius {} m", s.radius);
  }
  std::string operator()(const Box& s) const {
    return fmt::format("box, half extents {} m", FormatVector(s.half_extents));
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format("capsule, radius {} m, half length {} m", s.radius, s.half_length);
  }
  std::string operator()(const Cylinder& s) const {
    return fmt::format("cylinder, radius {} m, half length {} m", s.radius,
                       s.half_length);
  }
  std::string operator()(const Cone& s) const {
    return fmt::format("cone, radius {} m, half height {} m", s.radius, s.half_height);
  }
  std::string operator()(const ConvexHull& s) const {
    return "convex hull of " + Counted(s.vertices.size(), "vertex", "vertices");
  }
  std::string operator()(const HalfSpace&) const { return "half-space"; }
};

/** Returns the rotation of a pose as a clause; empty for the identity. */
std::string RotationOf(const Pose& pose) {
  if (pose.R_WB == Eigen::Matrix3d::Identity()) return "";
  if (pose.q_WB) {
    const Eigen::Quaterniond& q = *pose.q_WB;
    return fmt::format(", turned by the quaternion (w, x, y, z) = ({}, {}, {}, {})",
                       q.w(), q.x(), q.y(), q.z());
  }
  const auto row = [&](int i) { return FormatVector(Eigen::Vector3d(pose.R_WB.row(i))); };
  return fmt::format(", turned by the matrix with the rows {}, {}, {}", row(0), row(1),
                     row(2));
}

}  // namespace

std::string_view NameOf(Touching touching) {
  switch (touching) {
    case Touching::kApart:
      return "apart";
    case Touching::kTouching:
      return "touching";
    case Touching::kUndecided:
      return "undecided";
  }
  return "undecided";
}

std::string Describe(const Body& body) {
  return fmt::format("{} at {}{}", std::visit(DescribeShape{}, body.shape),
                     FormatVector(body.X_WB.p_WB), RotationOf(body.X_WB));
}

std::string Describe(const ContactQuery& query, const ContactTruth& truth) {
  std::string state(NameOf(truth.touching));
  // The numbers of an exact scene decide what rounded ones could not.
  if (truth.touching == Touching::kUndecided && IsExactScene(query, 0x1p-53)) {
    if (const auto touching = TouchingInExactScene(query, truth))
      state = fmt::format("{}, exactly", *touching ? "touching" : "apart");
  }
  state[0] = static_cast<char>(std::toupper(state[0]));
  const auto& [lo, hi] = truth.separation;
  const std::string separation =
      lo == hi ? fmt::format("is {} m", lo) : fmt::format("lies in [{}, {}] m", lo, hi);
  return fmt::format(
      "{}: the separation {}, certified along n = {} by the points {} of "
      "A and "
      "{} of B.",
      state, separation, FormatVector(truth.certificate.n_AB_W),
      FormatVector(truth.certificate.p_WCa), FormatVector(truth.certificate.p_WCb));
}

double LeastError(double separation, const ContactTruth& truth) {
  if (separation < truth.separation.lo) return truth.separation.lo - separation;
  if (separation > truth.separation.hi) return separation - truth.separation.hi;
  return std::isnan(separation) ? separation : 0;
}

}  // namespace touchstone
