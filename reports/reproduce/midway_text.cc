#include "reports/reproduce/midway_text.h"

#include <variant>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"

namespace touchstone {
namespace {

/** Writes the distance of the point (x, y, z) of the body's frame from a surface. */
struct Misfit {
  std::string operator()(const Sphere& s) const {
    return fmt::format("  return std::abs(std::sqrt(x * x + y * y + z * z) - {});\n",
                       Literal(s.radius));
  }
  std::string operator()(const Box& s) const {
    return fmt::format(
        "  return std::abs(std::max({{std::abs(x) - {}, std::abs(y) - {}, std::abs(z) - "
        "{}}}));\n",
        Literal(s.half_extents.x()), Literal(s.half_extents.y()),
        Literal(s.half_extents.z()));
  }
  std::string operator()(const Capsule& s) const {
    return fmt::format(
        "  const double beyond = z - std::clamp(z, -{1}, {1});\n"
        "  const double round = std::abs(std::sqrt(x * x + y * y + beyond * beyond) - "
        "{0});\n"
        "  // A deep capsule is taken as a box.\n"
        "  const double box = std::max({{std::abs(x) - {0}, std::abs(y) - {0}, "
        "std::abs(z) - ({0} + {1})}});\n"
        "  return std::min(round, std::abs(box));\n",
        Literal(s.radius), Literal(s.half_length));
  }
  std::string operator()(const Cylinder& s) const {
    return fmt::format(
        "  return std::abs(std::max(std::hypot(x, y) - {}, std::abs(z) - {}));\n",
        Literal(s.radius), Literal(s.half_length));
  }
  template <typename Other>
  std::string operator()(const Other&) const {
    return "  return 0 * (x + y + z);\n";
  }
};

std::string MisfitText(char name, const Body& body) {
  return fmt::format("double Misfit{}(double u, double v, double w) {{\n{}{}}}\n", name,
                     InBodyFrame(body.X_WB), std::visit(Misfit{}, body.shape));
}

}  // namespace

std::string BestShiftText(const ContactQuery& query) {
  return "// How far a point is from the surfaces of A and B.\n" +
         MisfitText('A', query.A) + MisfitText('B', query.B) + R"(
// The engine puts a contact on A, on B or midway between its points on them. Which one is
// told by the shift along the normal n after which it fits both surfaces best as midway.
double BestShift(std::initializer_list<double> shifts, const Vector& p, const Vector& n,
                 double depth) {
  const double half = depth / 2;
  double best = 0, least = INFINITY;
  for (const double shift : shifts) {
    Vector m;
    for (int i = 0; i < 3; ++i) m[i] = p[i] + shift * n[i];
    const double misfit =
        MisfitA(m[0] + half * n[0], m[1] + half * n[1], m[2] + half * n[2]) +
        MisfitB(m[0] - half * n[0], m[1] - half * n[1], m[2] - half * n[2]);
    if (misfit < least) {
      least = misfit;
      best = shift;
    }
  }
  return best;
}

)";
}

std::string ShiftOfSphereAtBox(const ContactQuery& query) {
  const bool first = std::holds_alternative<Sphere>(query.A.shape);
  const Body& ball = first ? query.A : query.B;
  const Body& box = first ? query.B : query.A;
  const Eigen::Vector3d centre_B =
      box.X_WB.R_WB.transpose() * (ball.X_WB.p_WB - box.X_WB.p_WB);
  const Eigen::Vector3d& half_extents = std::get<Box>(box.shape).half_extents;
  if ((centre_B.cwiseAbs() - half_extents).maxCoeff() > 0)
    return first ? "half" : "-half";
  return fmt::format(fmt::runtime(first ? "{} - half" : "-({} - half)"),
                     Literal(std::get<Sphere>(ball.shape).radius));
}

}  // namespace touchstone
