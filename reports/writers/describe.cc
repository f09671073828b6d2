#include "reports/writers/describe.h"

#include <cmath>

#include <fmt/format.h>

namespace touchstone {
namespace {

struct DescribeShape {
  std::string operator()(const Sphere& s) const {
    return fmt::format("sphere, radius {} m", s.radius);
  }
  std::string operator()(const Box& s) const {
    return fmt::format("box, half extents {} m", Describe(s.half_extents));
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
    return fmt::format("convex hull of {} vertices", s.vertices.size());
  }
  std::string operator()(const HalfSpace&) const { return "half-space"; }
};

const char* StateOf(Touching touching) {
  switch (touching) {
    case Touching::kApart:
      return "Apart";
    case Touching::kTouching:
      return "Touching";
    case Touching::kUndecided:
      return "Undecidable";
  }
  return "Undecidable";
}

}  // namespace

std::string Describe(const Eigen::Vector3d& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
}

std::string Describe(const Body& body) {
  return fmt::format("{} at {}", std::visit(DescribeShape{}, body.shape),
                     Describe(body.X_WB.p_WB));
}

std::string Describe(const ContactTruth& truth) {
  return fmt::format(
      "{}: the separation lies in [{}, {}] m, certified along n = {} by the points {} of "
      "A and "
      "{} of B ({}).",
      StateOf(truth.touching), truth.separation.lo, truth.separation.hi,
      Describe(truth.certificate.n_AB_W), Describe(truth.certificate.p_WCa),
      Describe(truth.certificate.p_WCb), truth.method);
}

double LeastError(double separation, const ContactTruth& truth) {
  if (separation < truth.separation.lo) return truth.separation.lo - separation;
  if (separation > truth.separation.hi) return separation - truth.separation.hi;
  return std::isnan(separation) ? separation : 0;
}

}  // namespace touchstone
