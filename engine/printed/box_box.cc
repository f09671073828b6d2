#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/collision/rounding.h"
#include "engine/printed/box_contacts.h"
#include "engine/printed/collide.h"

namespace cookbook::printed {
namespace {

struct Interval {
  double min;
  double max;
};

Interval Shadow(const PlacedBox& box, const Eigen::Vector3d& n_W) {
  const double centre = n_W.dot(box.X_WB.p_WB);
  const double reach = box.Reach(n_W);
  return {centre - reach, centre + reach};
}

/** Returns a b − c d to within two roundings of the result, even if the products cancel.
 Source: Kahan; Jeannerod, Louvet & Muller, Math. Comp. 82 (2013), algorithm 1. */
double DifferenceOfProducts(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/** Returns a × b. The products of nearly parallel axes cancel: if rounded, they would
 turn the normal by u / |a × b|, so that it is no longer perpendicular to the edges. */
Eigen::Vector3d Cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {DifferenceOfProducts(a.y(), b.z(), a.z(), b.y()),
          DifferenceOfProducts(a.z(), b.x(), a.x(), b.z()),
          DifferenceOfProducts(a.x(), b.y(), a.y(), b.x())};
}

/** The search for the axis of least depth: tries one axis after another. */
class Search {
 public:
  Search(const PlacedBox& A, const PlacedBox& B, const Errata& errata)
      : A_(A), B_(B), errata_(errata) {}

  bool apart() const { return apart_; }
  const std::optional<LeastDepth>& least() const { return least_; }

  void Try(Eigen::Vector3d axis_W) {
    if (errata_.Has(Erratum::kE02)) {
      for (double& component : axis_W) {
        if (component < 1e-6) component = 0;  // The published constant.
      }
    }
    const double squared_length = axis_W.squaredNorm();
    if (squared_length <= LeastSquaredLength()) return;
    const LeastDepth found = Along(axis_W / std::sqrt(squared_length));
    if (found.depth < 0) apart_ = true;
    if (found.depth == 0 && errata_.Has(Erratum::kE28)) apart_ = true;
    if (!least_ || Better(found)) least_ = found;
  }

 private:
  /** Returns the squared length up to which an axis is skipped. */
  double LeastSquaredLength() const {
    return errata_.Has(Erratum::kE29) ? 1e-3 : kParallelSquared;  // As published.
  }

  LeastDepth Along(const Eigen::Vector3d& n_W) const {
    if (errata_.Has(Erratum::kE26)) {
      const Interval a = Shadow(A_, n_W);
      const Interval b = Shadow(B_, n_W);
      return {b.min < a.min ? Eigen::Vector3d(-n_W) : n_W,
              std::min(a.max, b.max) - std::max(a.min, b.min)};
    }
    const double offset = n_W.dot(B_.X_WB.p_WB - A_.X_WB.p_WB);
    return {offset < 0 ? Eigen::Vector3d(-n_W) : n_W,
            A_.Reach(n_W) + B_.Reach(n_W) - std::abs(offset)};
  }

  /** Ties to within rounding go to the axis tried first: A's faces, B's faces, edges. */
  bool Better(const LeastDepth& found) const {
    const double size = A_.box.half_extents.sum() + B_.box.half_extents.sum();
    return found.depth < least_->depth - 2 * kOverlapRounding * size;
  }

  const PlacedBox& A_;
  const PlacedBox& B_;
  const Errata& errata_;
  bool apart_ = false;
  std::optional<LeastDepth> least_;
};

}  // namespace

Manifold Collide(const Box& A, const Pose& X_WA, const Box& B, const Pose& X_WB,
                 const Errata& errata) {
  const PlacedBox box_A{A, X_WA};
  const PlacedBox box_B{B, X_WB};
  Search search(box_A, box_B, errata);
  for (int i = 0; i < 3; ++i) search.Try(box_A.axis(i));
  for (int j = 0; j < 3; ++j) search.Try(box_B.axis(j));
  const PlacedBox& partner = errata.Has(Erratum::kE01) ? box_A : box_B;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) search.Try(Cross(box_A.axis(i), partner.axis(j)));
  }

  Manifold manifold;
  if (search.apart() || !search.least()) return manifold;
  manifold.touching = true;
  manifold.n_AB_W = search.least()->n_AB_W;
  manifold.depth = search.least()->depth;
  manifold.contacts_W = Contacts(box_A, box_B, *search.least(), errata);
  return manifold;
}

}  // namespace cookbook::printed
