#include "reports/referee/portal.h"

#include <utility>

namespace touchstone::referee {
namespace {

// A portal on a round face loses at least a constant factor of its height for every few
// steps; on a flat face the search ends. The certificate shows how far it got.
constexpr int kMostSteps = 400;

Eigen::Vector3d MiddleOf(const RoundedCore& placed) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  if (const auto* vertices = std::get_if<Vertices>(&placed.core)) {
    for (const Eigen::Vector3d& v : *vertices) {
      middle += v / static_cast<double>(vertices->size());
    }
  }
  return placed.X_WB * middle;
}

/** The search. Positions are relative to the middle of M. */
template <typename Real>
class PortalSearch {
 public:
  explicit PortalSearch(const MinkowskiDifference& M)
      : M_(M),
        middle_(Exactly<Real>(MiddleOf(M.A())) - Exactly<Real>(MiddleOf(M.B()))),
        ray_(-middle_),
        // A thousandth of a rounding of the result in double.
        tolerance_(kRoundoff<double> / 1024 * M.Size()) {}

  Portal<Real> Find() && {
    if (MakePortal()) Refine();
    return std::move(best_);
  }

 private:
  using V = Vector<Real>;
  using Point3 = DifferencePoint<Real>;

  /** Returns the support point along n, and keeps n if its overlap is the least so far.
   */
  Point3 Try(const V& n) {
    const Point3 w = M_.Support(n);
    const Real length = sqrt(Dot(n, n));
    if (length > 0) {
      const Real overlap = Dot(n, w.x) / length;
      if (!has_direction_ || overlap < least_) {
        has_direction_ = true;
        least_ = overlap;
        best_.n = n;
      }
    }
    return w;
  }

  V From(const Point3& p) const { return p.x - middle_; }
  /** Returns the side of the plane through the middle, a and b on which the ray is. */
  Real Side(const Point3& a, const Point3& b) const {
    return Dot(Cross(From(a), From(b)), ray_);
  }

  /** Finds three points of M whose cone from the middle contains the ray. */
  bool MakePortal() {
    a_ = Try(ray_);
    const V across = Cross(From(a_), ray_);
    if (!(Dot(across, across) > 0)) return false;  // The ray itself is the direction.
    b_ = Try(across);
    for (int step = 0; step < kMostSteps; ++step) {
      V n = Cross(From(a_), From(b_));
      if (Dot(n, ray_) < 0) {
        std::swap(a_, b_);
        n = -n;
      }
      c_ = Try(n);
      if (!(Dot(n, From(c_)) > 0)) return false;  // M is flat.
      if (Side(a_, c_) > 0) {
        b_ = c_;
      } else if (Side(c_, b_) > 0) {
        a_ = c_;
      } else {
        return true;
      }
    }
    return false;
  }

  /** Moves the portal outwards until its plane supports M. */
  void Refine() {
    for (int step = 0; step < kMostSteps; ++step) {
      Keep();
      V n = Cross(b_.x - a_.x, c_.x - a_.x);
      if (Dot(n, ray_) < 0) n = -n;
      const Real length = sqrt(Dot(n, n));
      if (!(length > 0)) return;
      const Point3 w = Try(n);
      if (Dot(n, w.x - a_.x) <= tolerance_ * length) return;
      // The ray meets one of the three triangles of w with a side of the portal.
      const V across = Cross(From(w), ray_);
      const bool past_a = Dot(From(a_), across) <= 0;
      const bool past_b = Dot(From(b_), across) <= 0;
      const bool past_c = Dot(From(c_), across) <= 0;
      if (past_a) {
        (past_b ? a_ : c_) = w;
      } else {
        (past_c ? b_ : a_) = w;
      }
    }
  }

  void Keep() {
    best_.simplex.points = {a_, b_, c_, Point3{}};
    best_.simplex.count = 3;
  }

  const MinkowskiDifference& M_;
  const V middle_;
  const V ray_;
  const Real tolerance_;
  Point3 a_, b_, c_;
  bool has_direction_ = false;
  Real least_;
  Portal<Real> best_;
};

}  // namespace

template <typename Real>
Portal<Real> FindPortal(const MinkowskiDifference& M) {
  return PortalSearch<Real>(M).Find();
}

template Portal<DoubleDouble> FindPortal(const MinkowskiDifference&);
template Portal<Precise> FindPortal(const MinkowskiDifference&);

}  // namespace touchstone::referee
