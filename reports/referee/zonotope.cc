#include "reports/referee/zonotope.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "reports/referee/direction.h"

namespace touchstone::referee {
namespace {

struct Generator {
  Eigen::Vector3d direction;  ///< A column of a pose's matrix, without rounding.
  std::vector<double>
      half_lengths;  ///< Half lengths of parallel edges; their sum counts. [m]
};

void AddGenerator(const Eigen::Vector3d& direction, double half_length,
                  std::vector<Generator>* generators) {
  // Bodies of one orientation have edges that are equal to the bit. Merging them leaves
  // fewer candidates. Edges parallel only in exact arithmetic are distinguished by their
  // exact cross product.
  for (Generator& generator : *generators) {
    if (generator.direction == direction || generator.direction == -direction) {
      generator.half_lengths.push_back(half_length);
      return;
    }
  }
  generators->push_back({direction, {half_length}});
}

void AddGenerators(const RoundedCore& placed, std::vector<Generator>* generators) {
  const Eigen::Matrix3d& R = placed.X_WB.R_WB;
  if (const auto* segment = std::get_if<Segment>(&placed.core)) {
    AddGenerator(R.col(2), segment->half_length, generators);
  } else if (const auto* box = std::get_if<Box>(&placed.core)) {
    for (int i = 0; i < 3; ++i) AddGenerator(R.col(i), box->half_extents[i], generators);
  }
}

struct Candidate {
  Enclosure overlap{std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity()};
  Eigen::Vector3d n_AB_W = Eigen::Vector3d::Zero();  ///< Only in high precision.
};

/** Returns the lesser overlap of the two along ± the cross product of two generators. If
 the product is exactly zero, there is no such face and the overlap is infinite. */
template <typename Real>
Candidate Evaluate(const MinkowskiDifference& M, const std::vector<Generator>& generators,
                   std::size_t i, std::size_t j) {
  using Number = Bounded<Real>;
  Candidate candidate;
  Vector<Number> n = Cross(Exactly<Number>(generators[i].direction),
                           Exactly<Number>(generators[j].direction));
  // Products of two doubles are exact in Precise, and a correctly rounded difference is
  // zero only where it is zero in truth.
  if (std::is_same_v<Real, Precise> && n.x.value() == 0 && n.y.value() == 0 &&
      n.z.value() == 0) {
    return candidate;
  }
  const Number along = Dot(n, M.Centre<Real>());
  if (along.value() > 0) n = -n;
  Number overlap = -Abs(along);
  for (std::size_t k = 0; k < generators.size(); ++k) {
    if (k == i || k == j) continue;  // Perpendicular by construction.
    Number half_length;
    for (double h : generators[k].half_lengths) half_length = half_length + Number(h);
    overlap =
        overlap + half_length * Abs(Dot(n, Exactly<Number>(generators[k].direction)));
  }
  candidate.overlap = (overlap / Norm(n)).enclosure();
  if constexpr (std::is_same_v<Real, Precise>) {
    candidate.n_AB_W = Direction({n.x.value(), n.y.value(), n.z.value()});
  }
  return candidate;
}

}  // namespace

bool IsZonotope(const Core& core) {
  return std::holds_alternative<Point>(core) || std::holds_alternative<Segment>(core) ||
         std::holds_alternative<Box>(core);
}

std::optional<CoreDepth> ZonotopeDepth(const MinkowskiDifference& M) {
  std::vector<Generator> generators;
  AddGenerators(M.A(), &generators);
  AddGenerators(M.B(), &generators);

  struct Pair {
    std::size_t i, j;
    double lo;
  };
  std::vector<Pair> pairs;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < generators.size(); ++i) {
    for (std::size_t j = i + 1; j < generators.size(); ++j) {
      const Enclosure overlap = Evaluate<double>(M, generators, i, j).overlap;
      pairs.push_back({i, j, overlap.lo});
      least = std::min(least, overlap.hi);
    }
  }
  // Only candidates that may be the least are evaluated again in high precision.
  CoreDepth best{
      {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()},
      Eigen::Vector3d::Zero()};
  for (const Pair& pair : pairs) {
    if (pair.lo > least) continue;
    const Candidate candidate = Evaluate<Precise>(M, generators, pair.i, pair.j);
    if (candidate.overlap.hi < best.depth.hi) best.n_AB_W = candidate.n_AB_W;
    best.depth.lo = std::min(best.depth.lo, candidate.overlap.lo);
    best.depth.hi = std::min(best.depth.hi, candidate.overlap.hi);
  }
  if (best.depth.hi == std::numeric_limits<double>::infinity()) return std::nullopt;
  return best;
}

}  // namespace touchstone::referee
