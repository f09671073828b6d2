#include "reports/referee/inner_polytope.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "reports/referee/direction.h"

namespace touchstone::referee {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Real>
Real Length(const Vector<Real>& a) {
  using std::sqrt;
  return sqrt(Dot(a, a));
}

template <typename Real>
Vector<Real> UnitPerpendicular(const Vector<Real>& a) {
  using std::abs;
  const Vector<Real> x{Real(1), Real(0), Real(0)};
  const Vector<Real> y{Real(0), Real(1), Real(0)};
  const Vector<Real> b = Cross(a, abs(a.x) < abs(a.y) ? x : y);
  const Real length = Length(b);
  return length > 0 ? (Real(1) / length) * b : x;
}

/** The search that grows an InnerPolytope. */
template <typename Real>
class Expansion {
 public:
  Expansion(const MinkowskiDifference& M, double target)
      : M_(M), rounding_(4 * kRoundoff<Real> * M.Size()), target_(target) {
    polytope_.overlap = Real(std::numeric_limits<double>::max());
  }

  InnerPolytope<Real> Grow(const Simplex<Real>& simplex, std::size_t most_vertices) {
    if (!MakeTetrahedron(simplex)) return std::move(polytope_);
    while (polytope_.vertices.size() < most_vertices && !nearest_.empty()) {
      const auto [distance, index] = nearest_.top();
      if (facet(index).removed) {
        nearest_.pop();
        continue;
      }
      // The facets of a growing convex polytope only move outwards. A polytope whose
      // facets do not has lost its convexity to rounding, and further steps would make it
      // worse.
      if (distance < reached_ - Real(4) * rounding_) break;
      if (reached_ < distance) reached_ = distance;
      if (distance >= polytope_.overlap - target_) break;
      const DifferencePoint<Real> w = Try(facet(index).n);
      if (Dot(facet(index).n, w.x) - distance <= target_) break;
      if (!Add(w, index)) break;
    }
    return std::move(polytope_);
  }

 private:
  using Entry = std::pair<Real, int>;
  struct FartherFirst {
    bool operator()(const Entry& a, const Entry& b) const { return b.first < a.first; }
  };

  Facet<Real>& facet(int index) {
    return polytope_.facets[static_cast<std::size_t>(index)];
  }
  const Vector<Real>& x(int index) const {
    return polytope_.vertices[static_cast<std::size_t>(index)].x;
  }

  /** Returns the support point along the unit vector n, and updates the least overlap
   found. */
  DifferencePoint<Real> Try(const Vector<Real>& n) {
    const DifferencePoint<Real> w = M_.Support(n);
    const Real overlap = Dot(n, w.x);
    if (overlap < polytope_.overlap) {
      polytope_.overlap = overlap;
      polytope_.n = n;
    }
    return w;
  }

  /** Adds the support point among ±`directions` with the largest `reach`. Returns false
   if even that one adds no dimension. */
  template <typename Reach>
  bool AddFarthest(std::initializer_list<Vector<Real>> directions, const Reach& reach) {
    Real most(0);
    DifferencePoint<Real> farthest;
    for (const Vector<Real>& direction : directions) {
      for (const Vector<Real>& n : {direction, -direction}) {
        const DifferencePoint<Real> w = Try(n);
        const Real r = reach(w.x);
        if (r > most) {
          most = r;
          farthest = w;
        }
      }
    }
    if (!(most > rounding_)) return false;
    polytope_.vertices.push_back(farthest);
    return true;
  }

  /** Completes the simplex to a tetrahedron, which contains the origin as the simplex
   does. Returns false if M is flat; the directions across it have then been tried. */
  bool MakeTetrahedron(const Simplex<Real>& simplex) {
    using std::abs;
    auto& v = polytope_.vertices;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
      v.push_back(simplex.points[i]);
    }
    if (v.size() == 1) {
      const Vector<Real> a = v[0].x;
      const auto reach = [&](const Vector<Real>& w) { return Length(w - a); };
      if (!AddFarthest({{Real(1), Real(0), Real(0)},
                        {Real(0), Real(1), Real(0)},
                        {Real(0), Real(0), Real(1)}},
                       reach)) {
        return false;
      }
    }
    if (v.size() == 2) {
      const Vector<Real> a = v[0].x;
      const Vector<Real> e = (Real(1) / Length(v[1].x - a)) * (v[1].x - a);
      const Vector<Real> u = UnitPerpendicular(e);
      const auto reach = [&](const Vector<Real>& w) { return Length(Cross(e, w - a)); };
      if (!AddFarthest({u, Cross(e, u)}, reach)) return false;
    }
    const auto unit_normal = [](const Vector<Real>& a, const Vector<Real>& b,
                                const Vector<Real>& c) {
      const Vector<Real> n = Cross(b - a, c - a);
      return (Real(1) / Length(n)) * n;
    };
    if (v.size() == 3) {
      const Vector<Real> a = v[0].x;
      const Vector<Real> n = unit_normal(a, v[1].x, v[2].x);
      const auto reach = [&](const Vector<Real>& w) { return Real(abs(Dot(n, w - a))); };
      if (!AddFarthest({n}, reach)) return false;
    }
    const Real volume = Dot(v[3].x - v[0].x, Cross(v[1].x - v[0].x, v[2].x - v[0].x));
    if (volume > 0)
      std::swap(v[1], v[2]);  // Afterwards the fourth is behind the first three.
    return AddFacet({0, 1, 2}, {1, 2, 3}) && AddFacet({1, 0, 3}, {0, 3, 2}) &&
           AddFacet({2, 1, 3}, {0, 1, 3}) && AddFacet({0, 2, 3}, {0, 2, 1});
  }

  bool AddFacet(const std::array<int, 3>& corners, const std::array<int, 3>& neighbours) {
    const Vector<Real>& a = x(corners[0]);
    const Vector<Real> n = Cross(x(corners[1]) - a, x(corners[2]) - a);
    const Real length = Length(n);
    if (!(length > 0)) return false;
    Facet<Real> added{corners, neighbours, (Real(1) / length) * n, Real(0)};
    added.distance = Dot(added.n, a);
    nearest_.push({added.distance, static_cast<int>(polytope_.facets.size())});
    polytope_.facets.push_back(added);
    return true;
  }

  /** Replaces the facets visible from w, those connected to `seen`, by a cone from their
   horizon to w. Returns false if rounding has broken the horizon into anything but one
   loop. */
  bool Add(const DifferencePoint<Real>& w, int seen) {
    struct Side {
      int from, to, beyond;
    };
    std::vector<int> visible = {seen};
    std::vector<Side> horizon;
    facet(seen).removed = true;
    for (std::size_t i = 0; i < visible.size(); ++i) {
      const Facet<Real> f = facet(visible[i]);
      for (std::size_t side = 0; side < 3; ++side) {
        Facet<Real>& g = facet(f.neighbours[side]);
        if (g.removed) continue;
        if (Dot(g.n, w.x) - g.distance > rounding_) {
          g.removed = true;
          visible.push_back(f.neighbours[side]);
        }
      }
    }
    for (int index : visible) {
      const Facet<Real>& f = facet(index);
      for (std::size_t side = 0; side < 3; ++side) {
        if (facet(f.neighbours[side]).removed) continue;
        horizon.push_back(
            {f.corners[side], f.corners[(side + 1) % 3], f.neighbours[side]});
      }
    }
    const auto forget = [&] {
      for (int index : visible) facet(index).removed = false;
      return false;
    };
    // Sort the sides of the horizon so that each begins where the last one ended.
    for (std::size_t i = 0; i + 1 < horizon.size(); ++i) {
      const auto next = std::find_if(
          horizon.begin() + static_cast<std::ptrdiff_t>(i) + 1, horizon.end(),
          [&](const Side& side) { return side.from == horizon[i].to; });
      if (next == horizon.end()) return forget();
      std::swap(horizon[i + 1], *next);
    }
    if (horizon.size() < 3 || horizon.back().to != horizon.front().from) return forget();

    const int apex = static_cast<int>(polytope_.vertices.size());
    polytope_.vertices.push_back(w);
    const int first = static_cast<int>(polytope_.facets.size());
    const int sides = static_cast<int>(horizon.size());
    for (int i = 0; i < sides; ++i) {
      const Side& side = horizon[static_cast<std::size_t>(i)];
      const int after = first + (i + 1) % sides;
      const int before = first + (i + sides - 1) % sides;
      if (!AddFacet({side.from, side.to, apex}, {side.beyond, after, before}))
        return false;
      Facet<Real>& beyond = facet(side.beyond);
      for (std::size_t k = 0; k < 3; ++k) {
        if (beyond.corners[k] == side.to) beyond.neighbours[k] = first + i;
      }
    }
    return true;
  }

  const MinkowskiDifference& M_;
  const Real rounding_;
  const Real target_;
  Real reached_{0};  ///< Largest distance of a nearest facet so far. [m]
  InnerPolytope<Real> polytope_;
  std::priority_queue<Entry, std::vector<Entry>, FartherFirst> nearest_;
};

/** Returns true if every side of every triangle is the reversed side of exactly one
 other. */
template <typename Real>
bool IsClosed(const std::vector<Facet<Real>>& facets) {
  std::vector<std::pair<int, int>> sides;
  for (const Facet<Real>& f : facets) {
    if (f.removed) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      sides.emplace_back(f.corners[i], f.corners[(i + 1) % 3]);
    }
  }
  if (sides.empty()) return false;
  std::sort(sides.begin(), sides.end());
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
  return std::all_of(sides.begin(), sides.end(), [&](const std::pair<int, int>& side) {
    return std::binary_search(sides.begin(), sides.end(),
                              std::pair(side.second, side.first));
  });
}

template <typename Number>
using Triangle = std::array<Vector<Number>, 3>;

template <typename Number>
bool KeepsOrientation(const Triangle<Number>& x) {
  return Dot(x[0], Cross(x[1], x[2])).enclosure().lo > 0;
}

/** Returns the least n·x_i / |n|: no point of the triangle is nearer to the origin. */
template <typename Number>
Enclosure DistanceAlong(const Triangle<Number>& x, const Vector<Number>& n) {
  const Number least = Min(Dot(n, x[0]), Min(Dot(n, x[1]), Dot(n, x[2])));
  return (least / Norm(n)).enclosure();
}

/** The corners of the facets over Bounded<Real>, computed on first use. */
template <typename Real, typename Search>
class Corners {
 public:
  Corners(const MinkowskiDifference& M, const InnerPolytope<Search>& polytope)
      : M_(M), polytope_(polytope), placed_(polytope.vertices.size()) {}

  Triangle<Bounded<Real>> Of(const Facet<Search>& f) {
    return {At(f.corners[0]), At(f.corners[1]), At(f.corners[2])};
  }

 private:
  const Vector<Bounded<Real>>& At(int corner) {
    const auto index = static_cast<std::size_t>(corner);
    if (!placed_[index]) {
      const DifferencePoint<Search>& point = polytope_.vertices[index];
      placed_[index] = M_.Place(Exactly<Real>(point.q_A), Exactly<Real>(point.q_B));
    }
    return *placed_[index];
  }

  const MinkowskiDifference& M_;
  const InnerPolytope<Search>& polytope_;
  std::vector<std::optional<Vector<Bounded<Real>>>> placed_;
};

template <typename Number>
Vector<Number> NormalOf(const Triangle<Number>& x) {
  return Cross(x[1] - x[0], x[2] - x[0]);
}

template <typename Real>
Eigen::Vector3d Direction(const Vector<Bounded<Real>>& n) {
  return referee::Direction(Vector<Real>{n.x.value(), n.y.value(), n.z.value()});
}

}  // namespace

template <typename Real>
InnerPolytope<Real> Expand(const MinkowskiDifference& M, const Simplex<Real>& simplex,
                           double target, std::size_t most_vertices) {
  return Expansion<Real>(M, target).Grow(simplex, most_vertices);
}

template <typename Real, typename Search>
DepthProof CertifyDepth(const MinkowskiDifference& M,
                        const InnerPolytope<Search>& polytope, double target) {
  using Number = Bounded<Real>;
  const Vector<Number> met = Exactly<Number>(polytope.n);
  DepthProof proof{{0, M.OverlapAlong(met).enclosure().hi}, Direction(met)};

  const Facet<Search>* nearest = nullptr;
  for (const Facet<Search>& f : polytope.facets) {
    if (!f.removed && (nearest == nullptr || f.distance < nearest->distance))
      nearest = &f;
  }
  if (nearest == nullptr) return proof;
  Corners<Real, Search> sharp(M, polytope);
  // The exact normal of the nearest facet. If it is a facet of M, both bounds meet.
  const Vector<Number> n = NormalOf(sharp.Of(*nearest));
  const double overlap = M.OverlapAlong(n).enclosure().hi;
  if (overlap < proof.depth.hi) proof = {{0, overlap}, Direction(n)};

  if (!IsClosed(polytope.facets)) return proof;
  double lo = kInfinity;
  Corners<double, Search> quick(M, polytope);
  for (const Facet<Search>& f : polytope.facets) {
    if (f.removed) continue;
    bool oriented = false;
    double distance = -kInfinity;
    if constexpr (std::is_same_v<Search, double>) {
      const Triangle<Bounded<double>> x = quick.Of(f);
      oriented = KeepsOrientation(x);
      distance = DistanceAlong(x, Exactly<Bounded<double>>(f.n)).lo;
    }
    if (!oriented && !KeepsOrientation(sharp.Of(f))) return proof;
    // Only a facet that could have the minimum is worth more digits.
    if (distance < proof.depth.hi + target) {
      const Triangle<Number> x = sharp.Of(f);
      distance = std::max(distance, DistanceAlong(x, NormalOf(x)).lo);
    }
    lo = std::min(lo, distance);
  }
  proof.depth.lo = std::max(0.0, lo);
  return proof;
}

template InnerPolytope<double> Expand(const MinkowskiDifference&, const Simplex<double>&,
                                      double, std::size_t);
template InnerPolytope<DoubleDouble> Expand(const MinkowskiDifference&,
                                            const Simplex<DoubleDouble>&, double,
                                            std::size_t);
template InnerPolytope<Precise> Expand(const MinkowskiDifference&,
                                       const Simplex<Precise>&, double, std::size_t);
template DepthProof CertifyDepth<DoubleDouble>(const MinkowskiDifference&,
                                               const InnerPolytope<double>&, double);
template DepthProof CertifyDepth<DoubleDouble>(const MinkowskiDifference&,
                                               const InnerPolytope<DoubleDouble>&,
                                               double);
template DepthProof CertifyDepth<Precise>(const MinkowskiDifference&,
                                          const InnerPolytope<double>&, double);
template DepthProof CertifyDepth<Precise>(const MinkowskiDifference&,
                                          const InnerPolytope<Precise>&, double);

}  // namespace touchstone::referee
