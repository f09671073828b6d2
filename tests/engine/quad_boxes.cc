#include "tests/engine/quad_boxes.h"

#include <algorithm>
#include <cmath>

namespace cookbook::test {
namespace {

Quad Abs(Quad x) {
  return x < 0 ? -x : x;
}

Quad Sqrt(Quad x) {
  if (x == 0) return 0;
  Quad root = std::sqrt(static_cast<double>(x));
  // Newton's method doubles the correct bits: 53 become 106, then all 113.
  for (int k = 0; k < 3; ++k) root = (root + x / root) / 2;
  return root;
}

QuadVector Cross(const QuadVector& a, const QuadVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}

Quad Reach(const QuadBox& box, const QuadVector& n) {
  return Abs(Dot(box.half_edges[0], n)) + Abs(Dot(box.half_edges[1], n)) +
         Abs(Dot(box.half_edges[2], n));
}

QuadVector Between(const QuadBox& A, const QuadBox& B) {
  return {B.centre[0] - A.centre[0], B.centre[1] - A.centre[1],
          B.centre[2] - A.centre[2]};
}

/** Calls `visit` with each axis of the separating-axis test that is not exactly zero. */
template <class Visit>
void ForEachAxis(const QuadBox& A, const QuadBox& B, const Visit& visit) {
  const auto Try = [&](const QuadVector& n) {
    if (Dot(n, n) > 0) visit(n);
  };
  for (const QuadBox* box : {&A, &B}) {
    for (std::size_t k = 0; k < 3; ++k) {
      Try(Cross(box->half_edges[(k + 1) % 3], box->half_edges[(k + 2) % 3]));
    }
  }
  for (const QuadVector& a : A.half_edges) {
    for (const QuadVector& b : B.half_edges) Try(Cross(a, b));
  }
}

}  // namespace

QuadBox::QuadBox(const Box& box, const Pose& X_WB) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto c = static_cast<std::size_t>(k);
    centre[c] = X_WB.p_WB[k];
    for (Eigen::Index r = 0; r < 3; ++r) {
      half_edges[c][static_cast<std::size_t>(r)] =
          static_cast<Quad>(X_WB.R_WB(r, k)) * box.half_extents[k];
    }
  }
}

Quad Dot(const QuadVector& a, const QuadVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Quad Length(const QuadVector& a) {
  return Sqrt(Dot(a, a));
}

Quad OverlapAlong(const QuadBox& A, const QuadBox& B, const QuadVector& n_W) {
  return (Reach(A, n_W) + Reach(B, n_W) - Dot(Between(A, B), n_W)) / Length(n_W);
}

Quad GreatestGap(const QuadBox& A, const QuadBox& B) {
  Quad greatest = -1e300;
  const QuadVector between = Between(A, B);
  ForEachAxis(A, B, [&](const QuadVector& n) {
    const Quad gap = (Abs(Dot(between, n)) - Reach(A, n) - Reach(B, n)) / Length(n);
    greatest = std::max(greatest, gap);
  });
  return greatest;
}

double DistanceForGap(const QuadBox& A, const QuadBox& B,
                      const Eigen::Vector3d& direction_W, double gap) {
  Quad least = 1e300;
  const QuadVector direction{direction_W[0], direction_W[1], direction_W[2]};
  ForEachAxis(A, B, [&](const QuadVector& n) {
    const Quad rise = Abs(Dot(direction, n));
    if (rise > 0)
      least = std::min(least, (gap * Length(n) + Reach(A, n) + Reach(B, n)) / rise);
  });
  return static_cast<double>(least);
}

double DistanceFromSurface(const Box& box, const Pose& X_WB, const QuadVector& p_W) {
  Quad outside_squared = 0;
  Quad inside = -1e300;
  for (Eigen::Index k = 0; k < 3; ++k) {
    Quad coordinate = 0;
    for (Eigen::Index r = 0; r < 3; ++r) {
      coordinate += (p_W[static_cast<std::size_t>(r)] - X_WB.p_WB[r]) * X_WB.R_WB(r, k);
    }
    const Quad beyond = Abs(coordinate) - box.half_extents[k];
    inside = std::max(inside, beyond);
    if (beyond > 0) outside_squared += beyond * beyond;
  }
  return static_cast<double>(outside_squared > 0 ? Sqrt(outside_squared) : -inside);
}

double PairSize(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB) {
  return (X_WB.p_WB - X_WA.p_WB).lpNorm<1>() + A.half_extents.sum() +
         B.half_extents.sum();
}

}  // namespace cookbook::test
