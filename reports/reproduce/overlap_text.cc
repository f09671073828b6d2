#include "reports/reproduce/overlap_text.h"

#include <utility>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"

namespace touchstone {
namespace {

constexpr const char* kSpheres = R"(
// The overlap of two spheres: the sum of the radii less the distance of the centres.
double Overlap(const WorldState& state) {{
  const Vector& a = state[{A}].p;
  const Vector& b = state[{B}].p;
  return {a} + {b} - std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}}
)";

constexpr const char* kSphereBox = R"(
// The overlap of a sphere and a box, from the centre c of the sphere in the box's frame.
double Overlap(const WorldState& state) {{
  const Vector& a = state[{A}].p;
  const Vector& b = state[{B}].p;
  const Matrix& R = state[{B}].R;
  const Vector half = {{{b}}};
  double highest = -INFINITY;  // Height of c above the nearest face; negative inside.
  double square = 0;           // Squared distance of c from the box.
  for (int i = 0; i < 3; ++i) {{
    const double c = R[i] * (a[0] - b[0]) + R[i + 3] * (a[1] - b[1]) +
                     R[i + 6] * (a[2] - b[2]);
    const double height = std::abs(c) - half[i];
    highest = std::max(highest, height);
    if (height > 0) square += height * height;
  }}
  return {a} - (highest > 0 ? std::sqrt(square) : highest);
}}
)";

constexpr const char* kSphereHalfSpace = R"(
// The overlap of a sphere and a half-space: the radius less the height of the centre.
double Overlap(const WorldState& state) {{
  const Vector& a = state[{A}].p;
  const Vector& b = state[{B}].p;
  const Matrix& R = state[{B}].R;  // Its third column is the outward normal.
  return {a} - (R[2] * (a[0] - b[0]) + R[5] * (a[1] - b[1]) + R[8] * (a[2] - b[2]));
}}
)";

constexpr const char* kBoxHalfSpace = R"(
// The overlap of a box and a half-space: the reach of the box against the normal less the
// height of its centre.
double Overlap(const WorldState& state) {{
  const Vector& a = state[{A}].p;
  const Vector& b = state[{B}].p;
  const Matrix& Q = state[{A}].R;
  const Matrix& R = state[{B}].R;  // Its third column is the outward normal.
  const Vector half = {{{a}}};
  double overlap = 0;
  for (int i = 0; i < 3; ++i) {{
    overlap += half[i] * std::abs(Q[i] * R[2] + Q[i + 3] * R[5] + Q[i + 6] * R[8]);
    overlap -= R[3 * i + 2] * (a[i] - b[i]);
  }}
  return overlap;
}}
)";

constexpr const char* kBoxes = R"(
// The overlap of two boxes: the least along their face normals and the cross products of
// their edges. No other direction is shorter (Gottschalk, Lin, Manocha, SIGGRAPH 1996).
double Overlap(const WorldState& state) {{
  const Matrix& Q = state[{A}].R;
  const Matrix& R = state[{B}].R;
  const Vector half_a = {{{a}}};
  const Vector half_b = {{{b}}};
  double least = INFINITY;
  const auto try_along = [&](Vector n) {{
    const double length = std::hypot(n[0], n[1], n[2]);
    if (length < 1e-9) return;  // Parallel edges.
    double overlap = 0;
    for (int i = 0; i < 3; ++i) {{
      overlap += half_a[i] * std::abs(Q[i] * n[0] + Q[i + 3] * n[1] + Q[i + 6] * n[2]);
      overlap += half_b[i] * std::abs(R[i] * n[0] + R[i + 3] * n[1] + R[i + 6] * n[2]);
    }}
    double apart = 0;
    for (int i = 0; i < 3; ++i) apart += n[i] * (state[{B}].p[i] - state[{A}].p[i]);
    least = std::min(least, (overlap - std::abs(apart)) / length);
  }};
  for (int i = 0; i < 3; ++i) {{
    const Vector a = {{Q[i], Q[i + 3], Q[i + 6]}};
    try_along(a);
    try_along({{R[i], R[i + 3], R[i + 6]}});
    for (int j = 0; j < 3; ++j) {{
      const Vector b = {{R[j], R[j + 3], R[j + 6]}};
      try_along({{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                 a[0] * b[1] - a[1] * b[0]}});
    }}
  }}
  return least;
}}
)";

/** Writes the sizes of a shape: a radius, or three half extents. */
struct Sizes {
  std::string operator()(const Sphere& s) const { return Literal(s.radius); }
  std::string operator()(const Box& s) const { return Literals(s.half_extents); }
  std::string operator()(const HalfSpace&) const { return ""; }
  template <typename Other>
  std::string operator()(const Other& s) const {
    throw CannotReproduce(fmt::format(
        "a program cannot compute the overlap of a {}; expected spheres, boxes and "
        "half-spaces",
        NameOf(KindOf(Shape{s}))));
  }
};

/** Returns the place of a shape in the names of the formulas: sphere, box, half-space. */
int Rank(const Shape& shape) {
  if (std::holds_alternative<Sphere>(shape)) return 0;
  return std::holds_alternative<Box>(shape) ? 1 : 2;
}

}  // namespace

std::string OverlapText(const World& world, int A, int B) {
  const auto shape_of = [&](int body) -> const Shape& {
    return world.bodies[static_cast<std::size_t>(body)].placed.shape;
  };
  const std::string sizes_A = std::visit(Sizes{}, shape_of(A));
  const std::string sizes_B = std::visit(Sizes{}, shape_of(B));
  if (Rank(shape_of(A)) > Rank(shape_of(B))) return OverlapText(world, B, A);
  constexpr const char* kFormulas[2][3] = {{kSpheres, kSphereBox, kSphereHalfSpace},
                                           {nullptr, kBoxes, kBoxHalfSpace}};
  return fmt::format(fmt::runtime(kFormulas[Rank(shape_of(A))][Rank(shape_of(B))]),
                     fmt::arg("A", A), fmt::arg("B", B), fmt::arg("a", sizes_A),
                     fmt::arg("b", sizes_B));
}

}  // namespace touchstone
