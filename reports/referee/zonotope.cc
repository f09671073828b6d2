#include "reports/referee/zonotope.h"

#include <algorithm>
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
      return;
    }
  }
  generators_.push_back({direction, {half_length}});
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
  Eigen::Vector3d n_AB_W = Eigen::Vector3d::Zero();  ///< Only in high precision.
};

/** Returns the lesser overlap of the two along ± the cross product of two generators. If
 the product is exactly zero, there is no such face and the overlap is infinite. */
template <typename Real>
ZonotopeFaces::Candidate ZonotopeFaces::Evaluate(std::size_t i, std::size_t j) const {
  using Number = Bounded<Real>;
  Candidate candidate;
  Vector<Number> n = Cross(Exactly<Number>(generators_[i].direction),
                           Exactly<Number>(generators_[j].direction));
  // Products of two doubles are exact in Precise, and a correctly rounded difference is
  // zero only where it is zero in truth.
  if (std::is_same_v<Real, Precise> && n.x.value() == 0 && n.y.value() == 0 &&
      n.z.value() == 0) {
    return candidate;
  }
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
  if constexpr (std::is_same_v<Real, Precise>) {
    candidate.n_AB_W = Direction({n.x.value(), n.y.value(), n.z.value()});
  }
  return candidate;
}

bool IsZonotope(const Core& core) {
  return std::holds_alternative<Point>(core) || std::holds_alternative<Segment>(core) ||
         std::holds_alternative<Box>(core);
}

ZonotopeFaces::ZonotopeFaces(const MinkowskiDifference& M)
    : M_(M), least_(std::numeric_limits<double>::infinity()) {
  AddGenerators(M.A());
  AddGenerators(M.B());
  for (std::size_t i = 0; i < generators_.size(); ++i) {
    for (std::size_t j = i + 1; j < generators_.size(); ++j) {
      const Enclosure overlap = Evaluate<double>(i, j).overlap;
      faces_.push_back({i, j, overlap.lo});
      least_ = std::min(least_, overlap.hi);
    }
  }
}

std::optional<CoreDepth> ZonotopeFaces::LeastOverlap() const {
  // Only candidates that may be the least are evaluated again in high precision.
  CoreDepth best{
      {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
      Eigen::Vector3d::Zero()};
  for (const Face& face : faces_) {
    if (face.lo > least_) continue;
    const Candidate candidate = Evaluate<Precise>(face.i, face.j);
    if (candidate.overlap.hi < best.depth.hi) best.n_AB_W = candidate.n_AB_W;
    best.depth.lo = std::min(best.depth.lo, candidate.overlap.lo);
    best.depth.hi = std::min(best.depth.hi, candidate.overlap.hi);
  }
  if (best.depth.hi == std::numeric_limits<double>::infinity()) return std::nullopt;
  return best;
}

}  // namespace touchstone::referee
