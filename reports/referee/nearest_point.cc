#include "reports/referee/nearest_point.h"

#include <algorithm>
#include <limits>

namespace touchstone::referee {
namespace {

// GJK gains at least a bit per step on flat faces and a constant factor on round ones. A
// search that has not converged by then will not, and the enclosure shows how far it got.
constexpr int kMostSteps = 300;

/** Sets v to the foot of the perpendicular from the origin on the plane of a triangle,
 unless that is a sliver. It is the combination of the corners, which near touching is a
 small difference of numbers of size L, and off by L/|v| roundings of itself. The normal n
 of the plane is off by L²/|n|. On a round rim a triangle has no more than the direction
 of its chords, however exact. */
template <typename Real>
void SetFootOnPlane(Simplex<Real>* triangle) {
  const Vector<Real>& a = triangle->points[0].x;
  const Vector<Real> ab = triangle->points[1].x - a;
  const Vector<Real> ac = triangle->points[2].x - a;
  const Vector<Real> n = Cross(ab, ac);
  const Real square = Dot(n, n);
  if (square > Dot(triangle->v, triangle->v) * (Dot(ab, ab) + Dot(ac, ac)))
    triangle->v = (Dot(n, a) / square) * n;
}

/** Computes the point nearest to the origin in the affine hull of `subset` of the points,
 which are those of a polytope if `is_flat`. Returns false if it lies outside their convex
 hull. */
template <typename Real>
bool SolveSubset(const Simplex<Real>& all, unsigned subset, bool is_flat,
                 Simplex<Real>* solved) {
  solved->count = 0;
  solved->encloses_origin = false;
  for (unsigned i = 0; i < static_cast<unsigned>(all.count); ++i) {
    if (subset >> i & 1) {
      solved->points[static_cast<std::size_t>(solved->count++)] = all.points[i];
    }
  }
  auto& points = solved->points;
  auto& weights = solved->weights;
  const Vector<Real>& a = points[0].x;
  const Vector<Real>& b = points[1].x;
  const Vector<Real>& c = points[2].x;
  const Vector<Real>& d = points[3].x;
  switch (solved->count) {
    case 1:
      weights[0] = Real(1);
      break;
    case 2: {
      const Vector<Real> e = b - a;
      weights[0] = Dot(e, b);
      weights[1] = Real(-Dot(e, a));
      break;
    }
    case 3: {
      // The weight of a corner is the area of the triangle that the projection of the
      // origin forms with the other two corners. n · (b × c) is that area times 2 |n|,
      // because the projection is along n.
      const Vector<Real> n = Cross(b - a, c - a);
      weights[0] = Dot(n, Cross(b, c));
      weights[1] = Dot(n, Cross(c, a));
      weights[2] = Dot(n, Cross(a, b));
      break;
    }
    default: {
      weights[0] = Real(-Dot(b, Cross(c, d)));
      weights[1] = Dot(a, Cross(c, d));
      weights[2] = Real(-Dot(a, Cross(b, d)));
      weights[3] = Dot(a, Cross(b, c));
      if (weights[0] < 0) {
        for (Real& weight : weights) weight = Real(-weight);
      }
      solved->encloses_origin = true;
    }
  }
  Real total(0);
  Vector<Real> sum{Real(0), Real(0), Real(0)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(solved->count); ++i) {
    if (!(weights[i] > 0)) return false;
    total = total + weights[i];
    sum = sum + weights[i] * points[i].x;
  }
  solved->v = (Real(1) / total) * sum;
  if (is_flat && solved->count == 3) SetFootOnPlane(solved);
  return true;
}

/** Returns the face of a simplex nearest to the origin, see SolveSubset(). */
template <typename Real>
Simplex<Real> NearestFace(const Simplex<Real>& all, bool is_flat) {
  Simplex<Real> best;
  Simplex<Real> candidate;
  Real least(std::numeric_limits<double>::max());
  for (unsigned subset = 1; subset < 1u << all.count; ++subset) {
    if (!SolveSubset(all, subset, is_flat, &candidate)) continue;
    if (candidate.encloses_origin) return candidate;
    const Real square = Dot(candidate.v, candidate.v);
    if (square < least) {
      least = square;
      best = candidate;
    }
  }
  return best;
}

}  // namespace

template <typename Real>
Simplex<Real> NearestOnSimplex(const Simplex<Real>& all) {
  return NearestFace(all, false);
}

template <typename Real>
Simplex<Real> FindNearest(const MinkowskiDifference& M, const Simplex<Real>& start) {
  Simplex<Real> simplex = start;
  if (simplex.count == 0) {
    simplex.points[0] = M.Support(Vector<Real>{Real(1), Real(0.5), Real(0.25)});
    simplex.weights[0] = Real(1);
    simplex.count = 1;
    simplex.v = simplex.points[0].x;
  }
  // v·w / |v| is uncertain by the rounding of numbers as large as M. Flat faces are found
  // in finitely many steps, so the tolerance is that rounding. Round faces are only
  // approached: a sixteenth of a double's roundoff (4 / 64) is near enough.
  const double roundoff =
      M.IsCurved() ? std::max(kRoundoff<Real>, kRoundoff<double> / 64) : kRoundoff<Real>;
  const Real tolerance = Real(4 * roundoff * M.Size());
  for (int step = 0; step < kMostSteps && !simplex.encloses_origin; ++step) {
    using std::sqrt;
    const Real square = Dot(simplex.v, simplex.v);
    const Real length = sqrt(square);
    if (length <= tolerance) break;
    const DifferencePoint<Real> w = M.Support(-simplex.v);
    if (square - Dot(simplex.v, w.x) <= tolerance * length) break;
    Simplex<Real> extended = simplex;
    extended.points[static_cast<std::size_t>(extended.count++)] = w;
    extended = NearestFace(extended, !M.IsCurved());
    if (extended.count == 0) break;
    if (!extended.encloses_origin && Dot(extended.v, extended.v) >= square) break;
    simplex = extended;
  }
  return simplex;
}

template <typename Real>
Simplex<Real> Sharpen(const MinkowskiDifference& M, const Simplex<double>& simplex) {
  Simplex<Real> all;
  all.count = simplex.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
    const DifferencePoint<double>& p = simplex.points[i];
    DifferencePoint<Real>& sharp = all.points[i];
    sharp.q_A = Exactly<Real>(p.q_A);
    sharp.q_B = Exactly<Real>(p.q_B);
    const Vector<Bounded<Real>> x = M.Place(sharp.q_A, sharp.q_B);
    sharp.x = {x.x.value(), x.y.value(), x.z.value()};
  }
  Simplex<Real> solved;
  const bool is_flat = !M.IsCurved();
  if (SolveSubset(all, (1u << all.count) - 1, is_flat, &solved)) return solved;
  return NearestFace(all, is_flat);
}

template <typename Real>
Enclosure CertifyNearest(const MinkowskiDifference& M, const Simplex<Real>& simplex) {
  using Number = Bounded<Real>;
  // The weights are exact positive numbers, so the combination is a point of M.
  Number total;
  Vector<Number> sum;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
    const Number weight(simplex.weights[i]);
    total = total + weight;
    sum = sum + weight * M.Place(simplex.points[i].q_A, simplex.points[i].q_B);
  }
  const Number distance = Norm(sum) / total;
  const Vector<Number> n = Exactly<Number>(-simplex.v);
  const Number overlap = M.SupportValue(n) / Norm(n);
  return {(-overlap).enclosure().lo, distance.enclosure().hi};
}

template Simplex<DoubleDouble> NearestOnSimplex(const Simplex<DoubleDouble>&);
template Simplex<Precise> NearestOnSimplex(const Simplex<Precise>&);
template Simplex<double> FindNearest(const MinkowskiDifference&, const Simplex<double>&);
template Simplex<DoubleDouble> FindNearest(const MinkowskiDifference&,
                                           const Simplex<DoubleDouble>&);
template Simplex<Precise> FindNearest(const MinkowskiDifference&,
                                      const Simplex<Precise>&);
template Enclosure CertifyNearest(const MinkowskiDifference&, const Simplex<double>&);
template Simplex<DoubleDouble> Sharpen(const MinkowskiDifference&,
                                       const Simplex<double>&);
template Simplex<Precise> Sharpen(const MinkowskiDifference&, const Simplex<double>&);
template Enclosure CertifyNearest(const MinkowskiDifference&,
                                  const Simplex<DoubleDouble>&);
template Enclosure CertifyNearest(const MinkowskiDifference&, const Simplex<Precise>&);

}  // namespace touchstone::referee
