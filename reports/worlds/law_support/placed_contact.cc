#include "reports/worlds/law_support/placed_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <variant>

namespace touchstone {
namespace {

/** An interval of places on a line. [m] */
struct Range {
  double least;
  double most;
};

/** Returns the least place at which the line p + t n may leave the face of `box` towards
 n, moved inwards by `error`. A contact of a box is on that face or at its border: edges
 and corners that face n are part of it. It is any of the faces that may be the one
 nearest to n after a turn by `turn` [rad]. */
double EndOfFace(const Box& box, double error, double turn, const BodyLine& line) {
  const auto& [p, n] = line;
  // A turn changes the difference of two cosines by at most |m₁ − m₂| = √2 times it.
  const double nearest = n.cwiseAbs().maxCoeff() - std::numbers::sqrt2 * turn;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double cosine = std::abs(n[i]);
    if (cosine < nearest || cosine == 0) continue;
    const double outside = n[i] < 0 ? -p[i] : p[i];
    least = std::min(least, (box.half_extents[i] - error - outside) / cosine);
  }
  return least;
}

/** Returns where A may end on the line if its surface is anywhere within `error` of its
 place; empty if the line then passes A. */
std::optional<Range> EndOf(const Shape& A, double error, double turn,
                           const BodyLine& line) {
  const std::optional<Chord> outer = ChordThrough(A, error, line);
  if (!outer) return std::nullopt;
  if (const Box* const box = std::get_if<Box>(&A))
    return Range{EndOfFace(*box, error, turn, line), outer->leaves};
  const std::optional<Chord> inner = ChordThrough(A, -error, line);
  return Range{inner ? inner->leaves : outer->enters, outer->leaves};
}

/** Returns where B may begin; `line` runs from B to A. */
std::optional<Range> BeginOf(const Shape& B, double error, double turn,
                             const BodyLine& line) {
  const std::optional<Range> end = EndOf(B, error, turn, line);
  if (!end) return std::nullopt;
  return Range{-end->most, -end->least};
}

/** Returns the point of `body` nearest to `p_W`, for a sphere that of its centre; empty
 for a half-space. */
std::optional<Eigen::Vector3d> NearestOfCore(const Body& body,
                                             const Eigen::Vector3d& p_W) {
  if (std::holds_alternative<Sphere>(body.shape)) return body.X_WB.p_WB;
  const Box* const box = std::get_if<Box>(&body.shape);
  if (box == nullptr) return std::nullopt;
  const Eigen::Vector3d p = body.X_WB.R_WB.transpose() * (p_W - body.X_WB.p_WB);
  const Eigen::Vector3d nearest =
      p.cwiseMax(-box->half_extents).cwiseMin(box->half_extents);
  return body.X_WB.p_WB + body.X_WB.R_WB * nearest;
}

/** Returns the vector whose direction is the only normal of a sphere with a sphere or a
 box, from A to B: that from the nearest point of the box to the centre. Zero if that is
 inside; empty for other pairs. */
std::optional<Eigen::Vector3d> CentreLine(const Body& A, const Body& B) {
  if (std::holds_alternative<Sphere>(B.shape)) {
    const std::optional<Eigen::Vector3d> p_WA = NearestOfCore(A, B.X_WB.p_WB);
    if (!p_WA) return std::nullopt;
    return B.X_WB.p_WB - *p_WA;
  }
  if (std::holds_alternative<Sphere>(A.shape)) {
    const std::optional<Eigen::Vector3d> p_WB = NearestOfCore(B, A.X_WB.p_WB);
    if (!p_WB) return std::nullopt;
    return *p_WB - A.X_WB.p_WB;
  }
  return std::nullopt;
}

}  // namespace

bool PlacedContact::IsTrueWithin(double error, const Lines& lines) const {
  const auto within = [&](double share) { return share > 0 ? share * error : rounding; };
  const std::optional<Range> a = EndOf(A.shape, within(share_A), turn_A, lines.out_of_A);
  const std::optional<Range> b =
      BeginOf(B.shape, within(share_B), turn_B, lines.out_of_B);
  if (!a || !b) return false;
  const double s = contact.separation;
  if (s < b->least - a->most || s > b->most - a->least) return false;
  return s < 0 ? b->least <= 0 && a->most >= 0 : a->least <= 0 && b->most >= 0;
}

double PlacedContact::LeastError(double most) const {
  const Lines lines{SeenFrom(A.X_WB, contact.p_WC, n_W),
                    SeenFrom(B.X_WB, contact.p_WC, -n_W)};
  if (IsTrueWithin(most, lines)) return LeastTrueError(most, lines);
  PlacedContact alike = *this;
  alike.share_A = 1;
  alike.share_B = 1;
  return alike.LeastTrueError(most, lines);
}

double PlacedContact::LeastTrueError(double most, const Lines& lines) const {
  if (IsTrueWithin(0, lines)) return 0;
  if (!IsTrueWithin(most, lines)) return most;
  double high = most;
  double low = most;
  while (low > 0 && IsTrueWithin(low, lines)) {
    high = low;
    low /= 16;
  }
  while (high - low > 1e-6 * high) {
    const double middle = (low + high) / 2;
    (IsTrueWithin(middle, lines) ? high : low) = middle;
  }
  return high;
}

double PlacedContact::LeastErrorOfNormal() const {
  const std::optional<Eigen::Vector3d> line = CentreLine(A, B);
  if (!line) return 0;
  const double along = std::max(0.0, line->dot(n_W));
  return (*line - along * n_W).norm() / (share_A + share_B);
}

double PlacedContact::TurnOfNormal() const {
  const std::optional<Eigen::Vector3d> line = CentreLine(A, B);
  return line ? line->norm() * std::max(turn_A, turn_B) : 0;
}

}  // namespace touchstone
