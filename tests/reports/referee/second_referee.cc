#include "tests/reports/referee/second_referee.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <variant>
#include <vector>

namespace touchstone {
namespace {

template <typename Real>
struct Triple {
  Real x, y, z;

  friend Triple operator+(const Triple& a, const Triple& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Triple operator-(const Triple& a, const Triple& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Triple operator*(const Real& s, const Triple& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  friend Real Dot(const Triple& a, const Triple& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  friend Triple Cross(const Triple& a, const Triple& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Real Length(const Triple& a) {
    using std::sqrt;
    return sqrt(Dot(a, a));
  }
};

template <typename Real>
Triple<Real> From(const Eigen::Vector3d& v) {
  return {Real(v.x()), Real(v.y()), Real(v.z())};
}

/** Finds the point of a shape that is farthest along m, in its body frame. Spheres and
 capsules count without their radius. */
template <typename Real>
struct Farthest {
  Triple<Real> m;

  Real Signed(const Real& along, double length) const {
    return along < 0 ? Real(-length) : Real(length);
  }
  Triple<Real> Disc(double radius, double z) const {
    using std::sqrt;
    const Real across = sqrt(m.x * m.x + m.y * m.y);
    if (across == 0) return {Real(0), Real(0), Real(z)};
    return {radius * m.x / across, radius * m.y / across, Real(z)};
  }

  Triple<Real> operator()(const Sphere&) const { return {Real(0), Real(0), Real(0)}; }
  Triple<Real> operator()(const Box& b) const {
    return {Signed(m.x, b.half_extents.x()), Signed(m.y, b.half_extents.y()),
            Signed(m.z, b.half_extents.z())};
  }
  Triple<Real> operator()(const Capsule& c) const {
    return {Real(0), Real(0), Signed(m.z, c.half_length)};
  }
  Triple<Real> operator()(const Cylinder& c) const {
    return Disc(c.radius, m.z < 0 ? -c.half_length : c.half_length);
  }
  Triple<Real> operator()(const Cone& c) const {
    const Triple<Real> apex{Real(0), Real(0), Real(c.half_height)};
    const Triple<Real> rim = Disc(c.radius, -c.half_height);
    return Dot(m, apex) > Dot(m, rim) ? apex : rim;
  }
  Triple<Real> operator()(const ConvexHull& hull) const {
    Triple<Real> best = From<Real>(hull.vertices.front());
    Real most = Dot(m, best);
    for (const Eigen::Vector3d& v : hull.vertices) {
      const Triple<Real> p = From<Real>(v);
      const Real along = Dot(m, p);
      if (along > most) {
        most = along;
        best = p;
      }
    }
    return best;
  }
  Triple<Real> operator()(const HalfSpace&) const { return {}; }
};

/** Returns the point of `body` that is farthest along n, from the body's origin. */
template <typename Real>
Triple<Real> FarthestOf(const Body& body, const Triple<Real>& n) {
  const Triple<Real> x = From<Real>(body.X_WB.R_WB.col(0));
  const Triple<Real> y = From<Real>(body.X_WB.R_WB.col(1));
  const Triple<Real> z = From<Real>(body.X_WB.R_WB.col(2));
  const Triple<Real> q =
      std::visit(Farthest<Real>{{Dot(n, x), Dot(n, y), Dot(n, z)}}, body.shape);
  return q.x * x + q.y * y + q.z * z;
}

/** Returns the point of A − B that is farthest along n, without the radii. */
template <typename Real>
Triple<Real> FarthestDifference(const ContactQuery& query, const Triple<Real>& n) {
  const Triple<Real> apart =
      From<Real>(query.A.X_WB.p_WB) - From<Real>(query.B.X_WB.p_WB);
  return apart + FarthestOf(query.A, n) - FarthestOf(query.B, Real(-1) * n);
}

double RadiusOf(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  return 0;
}

using Near = long double;

/** A direction with the point of A − B that is farthest along it. */
struct Corner {
  Triple<Near> n;
  Triple<Near> p;
  Near reach;
};

/** A cone of directions between three corners. */
struct Cell {
  std::array<std::size_t, 3> corners;
  Near bound;  ///< No direction in the cone reaches less far than this.

  friend bool operator<(const Cell& a, const Cell& b) { return a.bound > b.bound; }
};

using Matrix = std::array<std::array<Near, 3>, 3>;

/** Returns min_j Σ_i w_i a_ij, the value of a mixture. */
Near ValueOf(const Matrix& a, const std::array<Near, 3>& w) {
  Near least = INFINITY;
  for (std::size_t j = 0; j < 3; ++j)
    least = std::min(least, w[0] * a[0][j] + w[1] * a[1][j] + w[2] * a[2][j]);
  return least;
}

/** Returns the largest value found over mixtures of the rows: of single rows, of two rows
 that make two columns equal, and of three that make all equal. Each is a mixture, so none
 is too large. */
Near BestMixture(const Matrix& a) {
  Near best = -INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Near, 3> w{};
    w[i] = 1;
    best = std::max(best, ValueOf(a, w));
    const std::size_t k = (i + 1) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const Near d = a[i][j] - a[i][(j + 1) % 3];
      const Near e = a[k][j] - a[k][(j + 1) % 3];
      if (d * e >= 0) continue;
      w = {};
      w[i] = e / (e - d);
      w[k] = 1 - w[i];
      best = std::max(best, ValueOf(a, w));
    }
  }
  // The mixture is perpendicular to the differences of the columns.
  const Triple<Near> d{a[0][0] - a[0][1], a[1][0] - a[1][1], a[2][0] - a[2][1]};
  const Triple<Near> e{a[0][0] - a[0][2], a[1][0] - a[1][2], a[2][0] - a[2][2]};
  const Triple<Near> w = Cross(d, e);
  const Near total = w.x + w.y + w.z;
  if (total == 0) return best;
  const std::array<Near, 3> share{w.x / total, w.y / total, w.z / total};
  if (std::any_of(share.begin(), share.end(), [](Near s) { return !(s >= 0); }))
    return best;
  return std::max(best, ValueOf(a, share));
}

/** The search over all directions. */
class Search {
 public:
  Search(const ContactQuery& query, Near size) : query_(query), size_(size) {
    for (const double sign : {1.0, -1.0}) {
      Add({sign, 0, 0});
      Add({0, sign, 0});
      Add({0, 0, sign});
    }
    for (std::size_t i = 0; i < 8; ++i)
      Push({i & 1 ? 3U : 0U, i & 2 ? 4U : 1U, i & 4 ? 5U : 2U});
  }

  void Run() {
    // A thousand halvings of cones reach the last bit if the minimum is a point.
    constexpr int kMostSteps = 6000;
    for (int i = 0; i < kMostSteps && LeastPossible() < best().reach - 0x1p-60L * size_;
         ++i) {
      Divide();
    }
  }

  const Corner& best() const { return corners_[best_]; }
  Near LeastPossible() const { return cells_.top().bound; }
  /** The directions around the least bound. */
  std::vector<Triple<Near>> Last() const {
    std::vector<Triple<Near>> last{best().n};
    for (const std::size_t c : cells_.top().corners) last.push_back(corners_[c].n);
    return last;
  }

 private:
  std::size_t Add(const Triple<Near>& n) {
    const Triple<Near> p = FarthestDifference(query_, n);
    corners_.push_back({n, p, Dot(n, p)});
    if (corners_.back().reach < best().reach) best_ = corners_.size() - 1;
    return corners_.size() - 1;
  }

  void Push(const std::array<std::size_t, 3>& corners) {
    Matrix a;
    Near edge2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Triple<Near> side = corners_[corners[i]].n - corners_[corners[(i + 1) % 3]].n;
      edge2 = std::max(edge2, Dot(side, side));
      for (std::size_t j = 0; j < 3; ++j)
        a[i][j] = Dot(corners_[corners[i]].p, corners_[corners[j]].n);
    }
    Near bound = BestMixture(a);
    // The chord is inside the sphere: |Σ λ n|² = 1 − Σ λ_i λ_j |n_i − n_j|² >= 1 − e²/3.
    if (bound < 0) bound /= std::sqrt(1 - edge2 / 3);
    cells_.push({corners, bound});
  }

  /** Halves the cone that may reach least, at its longest side. */
  void Divide() {
    const Cell cell = cells_.top();
    cells_.pop();
    std::size_t longest = 0;
    Near most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Triple<Near> side =
          corners_[cell.corners[i]].n - corners_[cell.corners[(i + 1) % 3]].n;
      if (Dot(side, side) <= most) continue;
      most = Dot(side, side);
      longest = i;
    }
    const std::size_t a = cell.corners[longest];
    const std::size_t b = cell.corners[(longest + 1) % 3];
    const std::size_t c = cell.corners[(longest + 2) % 3];
    const Triple<Near> sum = corners_[a].n + corners_[b].n;
    const std::size_t middle = Add((1 / Length(sum)) * sum);
    Push({a, middle, c});
    Push({middle, b, c});
  }

  const ContactQuery& query_;
  Near size_;
  std::vector<Corner> corners_;
  std::size_t best_ = 0;
  std::priority_queue<Cell> cells_;
};

Wide GapAlong(const ContactQuery& query, const Triple<Wide>& n) {
  return -Dot(n, FarthestDifference(query, n)) / Length(n);
}

/** Returns the point of the segment that is nearest to the origin. */
Triple<Wide> NearestOf(const Triple<Wide>& a, const Triple<Wide>& b) {
  const Triple<Wide> side = b - a;
  const Wide length2 = Dot(side, side);
  if (length2 == 0) return a;
  const Wide t = -Dot(a, side) / length2;
  return t <= 0 ? a : t >= 1 ? b : a + t * side;
}

/** Returns the point of the triangle that is nearest to the origin. */
Triple<Wide> NearestOf(const Triple<Wide>& a, const Triple<Wide>& b,
                       const Triple<Wide>& c) {
  const Triple<Wide> m = Cross(b - a, c - a);
  const Wide area2 = Dot(m, m);
  if (area2 > 0) {
    const Triple<Wide> foot = (Dot(m, a) / area2) * m;
    const bool inside = Dot(m, Cross(b - a, foot - a)) >= 0 &&
                        Dot(m, Cross(c - b, foot - b)) >= 0 &&
                        Dot(m, Cross(a - c, foot - c)) >= 0;
    if (inside) return foot;
  }
  const std::array<Triple<Wide>, 3> feet{NearestOf(a, b), NearestOf(b, c),
                                         NearestOf(c, a)};
  return *std::min_element(feet.begin(), feet.end(), [](const auto& p, const auto& q) {
    return Dot(p, p) < Dot(q, q);
  });
}

/** Returns the separation from the plane of a half-space, whose normal is perpendicular
 to two axes of its pose. */
Wide SeparationFromPlane(const Body& plane, const Body& body) {
  const Triple<Wide> m =
      Cross(From<Wide>(plane.X_WB.R_WB.col(0)), From<Wide>(plane.X_WB.R_WB.col(1)));
  const Triple<Wide> lowest = From<Wide>(body.X_WB.p_WB) - From<Wide>(plane.X_WB.p_WB) +
                              FarthestOf(body, Wide(-1) * m);
  return Dot(m, lowest) / Length(m) - RadiusOf(body.shape);
}

/** Returns the sum of the distance of the origins and the radii of both bodies. [m] */
Near SizeOf(const ContactQuery& query) {
  return Length(From<Near>(query.A.X_WB.p_WB) - From<Near>(query.B.X_WB.p_WB)) +
         BoundingRadius(query.A.shape) + BoundingRadius(query.B.shape);
}

Triple<Wide> Widened(const Triple<Near>& v) {
  return {Wide(v.x), Wide(v.y), Wide(v.z)};
}

bool IsHalfSpace(const Body& body) {
  return std::holds_alternative<HalfSpace>(body.shape);
}

Wide Radii(const ContactQuery& query) {
  return Wide(RadiusOf(query.A.shape)) + Wide(RadiusOf(query.B.shape));
}

}  // namespace

WideEnclosure SeparationBySearch(const ContactQuery& query) {
  if (IsHalfSpace(query.A) || IsHalfSpace(query.B)) {
    const Wide s = IsHalfSpace(query.A) ? SeparationFromPlane(query.A, query.B)
                                        : SeparationFromPlane(query.B, query.A);
    const Wide rounding = Wide(SizeOf(query)) * Wide(0x1p-690);
    return {s - rounding, s + rounding};
  }
  const Near size = SizeOf(query);
  Search search(query, size);
  search.Run();

  std::vector<Triple<Wide>> points;
  Wide gap = GapAlong(query, Widened(search.best().n));
  const auto offer = [&](const Triple<Wide>& n) {
    if (Dot(n, n) > 0) gap = std::max(gap, GapAlong(query, n));
  };
  for (const Triple<Near>& n : search.Last())
    points.push_back(FarthestDifference(query, Widened(n)));
  // The rounding of the search: a support point costs some thirty operations, each off by
  // 2^-64 of the scene.
  Wide hi = -Wide(search.LeastPossible()) + Wide(size * 0x1p-58L);
  for (std::size_t skipped = 0; skipped < points.size(); ++skipped) {
    std::array<Triple<Wide>, 3> t;
    for (std::size_t i = 0; i < 3; ++i) t[i] = points[(skipped + 1 + i) % 4];
    const Triple<Wide> m = Cross(t[1] - t[0], t[2] - t[0]);
    const Triple<Wide> nearest = NearestOf(t[0], t[1], t[2]);
    for (const Triple<Wide>& n : {m, Wide(-1) * m, Wide(-1) * nearest}) offer(n);
    hi = std::min(hi, Length(nearest));
  }
  // The rounding of 700 bits.
  const Wide rounding = Wide(size) * Wide(0x1p-690);
  return {gap - Radii(query) - rounding, hi - Radii(query) + rounding};
}

Wide GapAlong(const ContactQuery& query, const Eigen::Vector3d& n_W) {
  return GapAlong(query, From<Wide>(n_W)) - Radii(query);
}

}  // namespace touchstone
