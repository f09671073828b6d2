#include "tests/reports/referee/independent_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/reports/referee/random_scene.h"

namespace touchstone {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

struct Reach {
  Vector n;  // In the body frame, not normalised.

  Real operator()(const Sphere& s) const { return s.radius * Length(); }
  Real operator()(const Box& b) const {
    return n.cwiseAbs().dot(b.half_extents.cast<Real>());
  }
  Real operator()(const Capsule& c) const {
    return c.half_length * std::abs(n.z()) + c.radius * Length();
  }
  Real operator()(const Cylinder& c) const {
    return c.half_length * std::abs(n.z()) + c.radius * std::hypot(n.x(), n.y());
  }
  Real operator()(const Cone& c) const {
    return std::max(c.half_height * n.z(),
                    c.radius * std::hypot(n.x(), n.y()) - c.half_height * n.z());
  }
  Real operator()(const ConvexHull& hull) const {
    Real most = -INFINITY;
    for (const Eigen::Vector3d& v : hull.vertices)
      most = std::max(most, n.dot(v.cast<Real>()));
    return most;
  }
  Real operator()(const HalfSpace&) const { return INFINITY; }

  Real Length() const { return n.norm(); }
};

Real SupportOf(const Body& body, const Vector& n) {
  return n.dot(body.X_WB.p_WB.cast<Real>()) +
         std::visit(Reach{body.X_WB.R_WB.transpose().cast<Real>() * n}, body.shape);
}

Real OverlapAlong(const ContactQuery& query, const Vector& n) {
  return (SupportOf(query.A, n) + SupportOf(query.B, -n)) / n.norm();
}

}  // namespace

double OverlapFound(const ContactQuery& query, const Eigen::Vector3d& n_W) {
  return static_cast<double>(OverlapAlong(query, n_W.cast<Real>()));
}

double LeastOverlapFound(const ContactQuery& query) {
  struct Start {
    Real overlap;
    Vector n;
  };
  std::vector<Start> starts;
  const auto offer = [&](const Vector& n) {
    if (n.norm() > 0) starts.push_back({OverlapAlong(query, n), n.normalized()});
  };
  constexpr int kDirections = 1500;
  for (int i = 0; i < kDirections; ++i) {  // A spiral from pole to pole.
    const Real z = 1 - (2 * i + 1) / static_cast<Real>(kDirections);
    const Real turn = i * std::numbers::pi_v<Real> * (3 - std::sqrt(Real(5)));
    const Real r = std::sqrt(1 - z * z);
    offer({r * std::cos(turn), r * std::sin(turn), z});
  }
  std::sort(starts.begin(), starts.end(),
            [](const Start& a, const Start& b) { return a.overlap < b.overlap; });
  RandomScene random(1);
  Real least = starts.front().overlap;
  for (std::size_t i = 0; i < 12; ++i) {
    Start best = starts[i];
    // Random steps follow creases too; they are halved when forty in a row gain nothing.
    for (Real step = 0.05L; step > 1e-12L; step /= 2) {
      for (int failures = 0; failures < 40; ++failures) {
        const Vector n = (best.n + step * random.Point(1).cast<Real>()).normalized();
        const Real overlap = OverlapAlong(query, n);
        if (overlap >= best.overlap) continue;
        best = {overlap, n};
        failures = 0;
      }
    }
    least = std::min(least, best.overlap);
  }
  return static_cast<double>(least);
}

}  // namespace touchstone
