#include "reports/referee/zonotope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/referee/direction.h"

namespace touchstone::referee {

void ZonotopeFaces::AddGenerator(const Eigen::Vector3d& direction, double half_length) {
  // Bodies of one orientation have edges that are equal to the bit. Merging them leaves
  // fewer candidates. Edges parallel only in exact arithmetic are distinguished by their
  // exact cross product.
  for (Generator& generator : generators_) {
    if (generator.direction == direction || generator.direction == -direction) {
      generator.half_lengths.push_back(half_length);
      generator.half_length += half_length;
      return;
    }
  }
  generators_.push_back({direction, {half_length}, half_length});
}

void ZonotopeFaces::AddGenerators(const RoundedCore& placed) {
  const Eigen::Matrix3d& R = placed.X_WB.R_WB;
  if (const auto* segment = std::get_if<Segment>(&placed.core)) {
    AddGenerator(R.col(2), segment->half_length);
  } else if (const auto* box = std::get_if<Box>(&placed.core)) {
    for (int i = 0; i < 3; ++i) AddGenerator(R.col(i), box->half_extents[i]);
  }
}

struct ZonotopeFaces::Candidate {
  Enclosure overlap{std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity()};
  Eigen::Vector3d n_AB_W = Eigen::Vector3d::Zero();
};

/** Returns the lesser overlap of the two along ± the cross product of two generators. If
 the product is exactly zero, there is no such face and the overlap is infinite. */
template <typename Real>
ZonotopeFaces::Candidate ZonotopeFaces::Evaluate(std::size_t i, std::size_t j) const {
  using Number = Bounded<Real>;
  Candidate candidate;
  Vector<Number> n = Cross(Exactly<Number>(generators_[i].direction),
                           Exactly<Number>(generators_[j].direction));
  // Products of two doubles are exact in `Real`, and a difference with a relative error
  // is zero only where it is zero in truth.
  if (n.x.value() == 0 && n.y.value() == 0 && n.z.value() == 0) return candidate;
  const Number along = Dot(n, M_.Centre<Real>());
  if (along.value() > 0) n = -n;
  Number overlap = -Abs(along);
  for (std::size_t k = 0; k < generators_.size(); ++k) {
    if (k == i || k == j) continue;  // Perpendicular by construction.
    Number half_length;
    for (double h : generators_[k].half_lengths) half_length = half_length + Number(h);
    overlap =
        overlap + half_length * Abs(Dot(n, Exactly<Number>(generators_[k].direction)));
  }
  candidate.overlap = (overlap / Norm(n)).enclosure();
  candidate.n_AB_W = Direction(Vector<Real>{n.x.value(), n.y.value(), n.z.value()});
  return candidate;
}

/** Sets the errors of RoughOverlap(). With u = 2^-53, G the largest |coordinate| of the
 generators, C = |c|₁ of the centre c and H the sum of the half lengths:
  - each coordinate of n, at most 2 G², is off by 4 u G²;
  - n · c is off by 6 u G² C for its own operations, 4 u G² C for n and 2 u G² C for c;
  - n · g, at most 6 G³, is off by 3 (6 + 4) u G³, and h |n · g| by 67 u G³ h, since the
    sum h is off by 5 u h;
  - a sum of five, at most 2 G² C + 6 G³ H, is off by 4 u of that: 8 u G² C + 24 u G³ H;
  - |n|, at most 3.5 G², is off by 7 u G² for n and 11 u G² for its own operations.
 Each is rounded up so far that the roundings of higher order and those of the bounds
 themselves are covered. 2^-900 covers products that underflow. */
void ZonotopeFaces::SetErrors() {
  constexpr double kRounding = 0x1p-53;
  constexpr double kTiny = 0x1p-900;
  double largest = 0;
  double half_lengths = 0;
  for (const Generator& generator : generators_) {
    largest = std::max(largest, generator.direction.lpNorm<Eigen::Infinity>());
    half_lengths += generator.half_length;
  }
  const double square = largest * largest;
  overlap_error_ =
      kRounding * square * (32 * centre_.lpNorm<1>() + 128 * largest * half_lengths) +
      kTiny;
  normal_error_ = 32 * kRounding * square + kTiny;
}

Enclosure ZonotopeFaces::RoughOverlap(std::size_t i, std::size_t j) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d n = generators_[i].direction.cross(generators_[j].direction);
  double overlap = -std::abs(n.dot(centre_));
  for (std::size_t k = 0; k < generators_.size(); ++k) {
    if (k == i || k == j) continue;  // Perpendicular by construction.
    overlap += generators_[k].half_length * std::abs(n.dot(generators_[k].direction));
  }
  const double length = n.norm();
  const double shortest = length - normal_error_;
  const double longest = length + normal_error_;
  // Written so that a NaN leaves the overlap unbounded.
  if (!(shortest > 0 && std::isfinite(overlap) && std::isfinite(overlap_error_)))
    return {-kInfinity, kInfinity};
  const double lo = overlap - overlap_error_;
  const double hi = overlap + overlap_error_;
  return {NextBelow(lo / (lo > 0 ? longest : shortest)),
          -NextBelow(-hi / (hi > 0 ? shortest : longest))};
}

bool IsZonotope(const Core& core) {
  return std::holds_alternative<Point>(core) || std::holds_alternative<Segment>(core) ||
         std::holds_alternative<Box>(core);
}

ZonotopeFaces::ZonotopeFaces(const MinkowskiDifference& M)
    : M_(M),
      centre_(M.A().X_WB.p_WB - M.B().X_WB.p_WB),
      least_(std::numeric_limits<double>::infinity()) {
  AddGenerators(M.A());
  AddGenerators(M.B());
  SetErrors();
  for (std::size_t i = 0; i < generators_.size(); ++i) {
    for (std::size_t j = i + 1; j < generators_.size(); ++j) {
      const Enclosure overlap = RoughOverlap(i, j);
      faces_.push_back({i, j, overlap.lo});
      least_ = std::min(least_, overlap.hi);
    }
  }
}

template <typename Real>
std::optional<CoreDepth> ZonotopeFaces::LeastOverlap() const {
  // Only candidates that may be the least are evaluated again in high precision.
  CoreDepth best{
      {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
      Eigen::Vector3d::Zero()};
  for (const Face& face : faces_) {
    if (face.lo > least_) continue;
    const Candidate candidate = Evaluate<Real>(face.i, face.j);
    if (candidate.overlap.hi < best.depth.hi) best.n_AB_W = candidate.n_AB_W;
    best.depth.lo = std::min(best.depth.lo, candidate.overlap.lo);
    best.depth.hi = std::min(best.depth.hi, candidate.overlap.hi);
  }
  if (best.depth.hi == std::numeric_limits<double>::infinity()) return std::nullopt;
  return best;
}

template std::optional<CoreDepth> ZonotopeFaces::LeastOverlap<DoubleDouble>() const;
template std::optional<CoreDepth> ZonotopeFaces::LeastOverlap<Precise>() const;

}  // namespace touchstone::referee
