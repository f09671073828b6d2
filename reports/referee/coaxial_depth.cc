#include "reports/referee/coaxial_depth.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace touchstone::referee {
namespace {

/** A direction in the half-plane: components away from the axis and along it, not
 normalised. */
template <typename Number>
struct Meridian {
  Number out, up;
};

/** The profile of a core whose own axis points along `sense` = ±1 times the common axis.
 */
template <typename Number>
class Profile {
 public:
  Profile(const Core& core, double sense) : core_(core), sense_(sense) {}

  Number Support(const Meridian<Number>& n) const {
    const Number up = sense_ < 0 ? -n.up : n.up;
    if (const auto* cylinder = std::get_if<Cylinder>(&core_)) {
      return Number(cylinder->radius) * n.out + Number(cylinder->half_length) * Abs(up);
    }
    if (const auto* cone = std::get_if<Cone>(&core_)) {
      const Number apex = Number(cone->half_height) * up;
      return Max(apex, Number(cone->radius) * n.out - apex);
    }
    const auto* segment = std::get_if<Segment>(&core_);
    return segment != nullptr ? Number(segment->half_length) * Abs(up) : Number();
  }

  /** Adds the outward normals of the profile's sides. */
  void AddNormals(std::vector<Meridian<Number>>* normals) const {
    const Number one(1.0);
    if (const auto* cone = std::get_if<Cone>(&core_)) {
      normals->push_back({Number(), Number(-sense_)});
      // The side falls from (0, h) to (r, −h); its outward normal is (2 h, r).
      const Number h(cone->half_height);
      normals->push_back({h + h, Number(sense_ * cone->radius)});
    } else if (std::holds_alternative<Cylinder>(core_)) {
      normals->push_back({Number(), one});
      normals->push_back({Number(), -one});
      normals->push_back({one, Number()});
    } else if (std::holds_alternative<Segment>(core_)) {
      normals->push_back({one, Number()});
    }
  }

 private:
  const Core& core_;
  double sense_;
};

bool IsRevolved(const Core& core) {
  return IsCurved(core) || std::holds_alternative<Point>(core) ||
         std::holds_alternative<Segment>(core);
}

template <typename Number>
Vector<Number> AxisOf(const RoundedCore& placed) {
  return Exactly<Number>(Eigen::Vector3d(placed.X_WB.R_WB.col(2)));
}

/** Returns a bound on |S − 1|₂ for R = Q S with the nearest rotation Q. The eigenvalues s
 of S obey |s − 1| = |s² − 1| / (s + 1) <= F / (2 − F) for the Frobenius norm F of RᵀR −
 1, since s >= 1 − F. */
template <typename Number>
double StretchOf(const Eigen::Matrix3d& R) {
  Number square;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Number entry = Dot(Exactly<Number>(Eigen::Vector3d(R.col(i))),
                               Exactly<Number>(Eigen::Vector3d(R.col(j)))) -
                           Number(i == j ? 1.0 : 0.0);
      square = square + entry * entry;
    }
  }
  const Number F = Sqrt(square);
  return (F / (Number(2.0) - F)).enclosure().hi;
}

/** Returns the sense of a core's axis along z, and a bound on how far aligning the axis
 with z moves a point of the core. [-, m] */
template <typename Number>
std::pair<double, double> Align(const RoundedCore& placed, const Vector<Number>& z) {
  if (std::holds_alternative<Point>(placed.core)) return {1, 0};
  const Vector<Number> axis = AxisOf<Number>(placed);
  const double sense = Dot(axis, z).value() < 0 ? -1 : 1;
  const double off = Norm(axis - Number(sense) * z).enclosure().hi;
  return {sense,
          (off + 2 * StretchOf<Number>(placed.X_WB.R_WB)) * CoreRadius(placed.core)};
}

}  // namespace

template <typename Real>
std::optional<DepthProof> CoaxialDepth(const MinkowskiDifference& M) {
  using Number = Bounded<Real>;
  if (!M.IsCurved() || !IsRevolved(M.A().core) || !IsRevolved(M.B().core)) return {};
  Vector<Number> z = AxisOf<Number>(referee::IsCurved(M.A().core) ? M.A() : M.B());
  z = (Number(1.0) / Norm(z)) * z;
  const auto [sense_A, moved_A] = Align(M.A(), z);
  const auto [sense_B, moved_B] = Align(M.B(), z);
  const Profile<Number> A(M.A().core, sense_A);
  const Profile<Number> reflected_B(M.B().core, -sense_B);

  // The origin relative to the centre of M.
  const Vector<Number> origin = -M.Centre<Real>();
  const Number up = Dot(origin, z);
  const Vector<Number> radial = origin - up * z;
  const Number out = Norm(radial);

  std::vector<Meridian<Number>> normals;
  A.AddNormals(&normals);
  reflected_B.AddNormals(&normals);
  Enclosure depth{std::numeric_limits<double>::infinity(),
                  std::numeric_limits<double>::infinity()};
  const Meridian<Number>* shallowest = nullptr;
  for (const Meridian<Number>& n : normals) {
    const Number overlap =
        (A.Support(n) + reflected_B.Support(n) - (n.out * out + n.up * up)) /
        Sqrt(n.out * n.out + n.up * n.up);
    const Enclosure bounds = overlap.enclosure();
    if (bounds.hi < depth.hi) shallowest = &n;
    depth = {std::min(depth.lo, bounds.lo), std::min(depth.hi, bounds.hi)};
  }
  const Number moved(Real(0), (moved_A + moved_B) * (1 + 0x1p-40));
  depth = {(Number(depth.lo) + moved).enclosure().lo,
           (Number(depth.hi) + moved).enclosure().hi};
  // There is no shallowest direction if every overlap overflows.
  if (shallowest == nullptr || !(depth.lo > 0)) return {};

  const auto rounded = [](const Vector<Number>& a) {
    return Eigen::Vector3d(Nearest(a.x.value()), Nearest(a.y.value()),
                           Nearest(a.z.value()));
  };
  const Eigen::Vector3d z_W = rounded(z);
  // On the axis every radial direction is equally good. An offset that may be zero has no
  // direction: that of its rounding need not even be radial.
  const Eigen::Vector3d out_W =
      out.enclosure().lo > 0 ? rounded(radial).stableNormalized() : z_W.unitOrthogonal();
  const Eigen::Vector3d n_W =
      Nearest(shallowest->out.value()) * out_W + Nearest(shallowest->up.value()) * z_W;
  return DepthProof{depth, n_W.normalized()};
}

template std::optional<DepthProof> CoaxialDepth<DoubleDouble>(const MinkowskiDifference&);
template std::optional<DepthProof> CoaxialDepth<Precise>(const MinkowskiDifference&);

}  // namespace touchstone::referee
