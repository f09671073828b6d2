#include "engine/printed/box_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/collision/rounding.h"

namespace cookbook::printed {
namespace {

/** Contacts closer than this fraction of the boxes' size are merged. It is far above the
 spread that rounding causes, and far below the size of any feature. */
constexpr double kMergedShare = 1e-6;

struct Line {
  Eigen::Vector3d p_W;
  Eigen::Vector3d d_W;
};

/** Returns the twelve edges, each as p + t d for t in [0, 1]. */
std::array<Line, 12> Edges(const PlacedBox& box) {
  std::array<Line, 12> edges;
  std::size_t count = 0;
  for (int k = 0; k < 3; ++k) {
    for (const double s1 : {-1.0, 1.0}) {
      for (const double s2 : {-1.0, 1.0}) {
        const int k1 = (k + 1) % 3;
        const int k2 = (k + 2) % 3;
        const Eigen::Vector3d& h = box.box.half_extents;
        const Eigen::Vector3d start = box.X_WB.p_WB - h[k] * box.axis(k) +
                                      s1 * h[k1] * box.axis(k1) +
                                      s2 * h[k2] * box.axis(k2);
        edges[count++] = {start, 2 * h[k] * box.axis(k)};
      }
    }
  }
  return edges;
}

/** A segment of a line, as an interval of t; empty if `end` < `begin`. */
struct Chord {
  double begin;
  double end;
};

/** Returns the segment of the line in [0, 1] that is inside the box. The tolerance is
 `tolerance` at faces that the line runs along, and `across` at faces that it crosses. [m]
 */
Chord Inside(const PlacedBox& box, const Line& line, double tolerance, double across) {
  const Eigen::Vector3d p = box.X_WB.R_WB.transpose() * (line.p_W - box.X_WB.p_WB);
  const Eigen::Vector3d d = box.X_WB.R_WB.transpose() * line.d_W;
  Chord chord{0, 1};
  for (int k = 0; k < 3; ++k) {
    const bool along = std::abs(d[k]) <= 2 * tolerance;
    const double h = box.box.half_extents[k] + (along ? tolerance : across);
    if (d[k] == 0) {
      if (std::abs(p[k]) > h) chord.end = -std::numeric_limits<double>::infinity();
      continue;
    }
    const double near = (std::copysign(h, -d[k]) - p[k]) / d[k];
    const double far = (std::copysign(h, d[k]) - p[k]) / d[k];
    chord.begin = std::max(chord.begin, near);
    chord.end = std::min(chord.end, far);
  }
  return chord;
}

/** Returns the segment of the line that is in the box. If the line only grazes the box to
 within `tolerance`, the segment is the single point where it is nearest. The tolerance
 decides whether a point is kept, not its position: a crossing lies on the face that it
 crosses. */
Chord Clip(const PlacedBox& box, const Line& line, double tolerance) {
  const Chord chord = Inside(box, line, tolerance, 0);
  if (chord.begin <= chord.end) return chord;
  const Chord grazing = Inside(box, line, tolerance, tolerance);
  if (grazing.begin > grazing.end) return grazing;
  const double middle = (grazing.begin + grazing.end) / 2;
  return {middle, middle};
}

/** The ends of the edges of one box, clipped by the other: crossings are ends made by the
 clipping, corners are ends that it left. */
struct ClippedEdges {
  std::vector<Eigen::Vector3d> crossings_W;
  std::vector<Eigen::Vector3d> corners_W;
};

void ClipEdges(const PlacedBox& of, const PlacedBox& by, double tolerance,
               ClippedEdges& clipped) {
  for (const Line& edge : Edges(of)) {
    const Chord chord = Clip(by, edge, tolerance);
    if (chord.begin > chord.end) continue;
    (chord.begin > 0 ? clipped.crossings_W : clipped.corners_W)
        .push_back(edge.p_W + chord.begin * edge.d_W);
    (chord.end < 1 ? clipped.crossings_W : clipped.corners_W)
        .push_back(edge.p_W + chord.end * edge.d_W);
  }
}

/** Returns the points, but only the first of any closer together than `distance`. */
std::vector<Eigen::Vector3d> Merged(const std::vector<Eigen::Vector3d>& points,
                                    double distance) {
  std::vector<Eigen::Vector3d> merged;
  for (const Eigen::Vector3d& point : points) {
    const bool known = std::ranges::any_of(merged, [&](const Eigen::Vector3d& other) {
      return (point - other).squaredNorm() < distance * distance;
    });
    if (!known) merged.push_back(point);
  }
  return merged;
}

ClippedEdges ClipBoth(const PlacedBox& A, const PlacedBox& B, const Errata& errata) {
  // A coordinate is a sum of some ten rounded terms, none above `size`: 32 is ample.
  const double size = A.box.half_extents.sum() + B.box.half_extents.sum() +
                      A.X_WB.p_WB.lpNorm<1>() + B.X_WB.p_WB.lpNorm<1>();
  const double tolerance = errata.Has(Erratum::kE27) ? 0 : 32 * kUnitRoundoff * size;
  ClippedEdges clipped;
  ClipEdges(B, A, tolerance, clipped);
  ClipEdges(A, B, tolerance, clipped);
  return clipped;
}

/** Returns the corners of the contact patch after B is moved out of A. */
std::vector<Eigen::Vector3d> Patch(const PlacedBox& A, const PlacedBox& B,
                                   const LeastDepth& least, const Errata& errata) {
  const Pose moved{B.X_WB.R_WB, B.X_WB.p_WB + least.depth * least.n_AB_W};
  const ClippedEdges clipped = ClipBoth(A, {B.box, moved}, errata);
  std::vector<Eigen::Vector3d> points = clipped.corners_W;
  points.insert(points.end(), clipped.crossings_W.begin(), clipped.crossings_W.end());
  return points;
}

}  // namespace

std::vector<Eigen::Vector3d> Contacts(const PlacedBox& A, const PlacedBox& B,
                                      const LeastDepth& least, const Errata& errata) {
  const ClippedEdges clipped = ClipBoth(A, B, errata);
  if (clipped.crossings_W.empty() && errata.Has(Erratum::kE07)) return {};

  std::vector<Eigen::Vector3d> points;
  if (!errata.Has(Erratum::kE08)) points = Patch(A, B, least, errata);
  // Moved along the wrong axis of another erratum, the boxes may not touch at all.
  if (points.empty()) points = clipped.crossings_W;
  if (points.empty()) points = clipped.corners_W;

  const Eigen::Vector3d on_plane =
      A.X_WB.p_WB + (A.Reach(least.n_AB_W) - least.depth / 2) * least.n_AB_W;
  for (Eigen::Vector3d& point : points) {
    point += least.n_AB_W.dot(on_plane - point) * least.n_AB_W;
  }
  const double size = A.box.half_extents.sum() + B.box.half_extents.sum();
  return Merged(points, errata.Has(Erratum::kE09) ? 1e-2 : kMergedShare * size);
}

}  // namespace cookbook::printed
