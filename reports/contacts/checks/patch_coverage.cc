#include "reports/contacts/checks/patch_coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "reports/contacts/checks/judged_answer.h"
#include "reports/contacts/checks/missed_point.h"
#include "reports/measures/convex_polygon.h"
#include "reports/measures/overlap_along.h"
#include "reports/referee/referee.h"

namespace touchstone {
namespace {

/** Returns the linear map after which the corners spread by one along both principal
 axes. An axis along which they have no spread is dropped. */
Eigen::Matrix2d Whitening(std::span<const Eigen::Vector2d> corners) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& c : corners)
    mean += c / static_cast<double>(corners.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& c : corners) spread += (c - mean) * (c - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  const Eigen::Matrix2d principal = axes.eigenvectors().transpose();
  // The axes are accurate to a rounding, but the smaller of two sums of squares loses
  // half its digits. The lengths are therefore computed again along the axes.
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  double farthest = 0;
  for (const Eigen::Vector2d& c : corners) {
    squares += (principal * (c - mean)).cwiseAbs2();
    farthest = std::max(farthest, c.norm());
  }
  // A length below this is only a segment's own rounding: a handful of 2^-53 in the
  // corners, their mean and the axes.
  const double least = farthest * 0x1p-48;
  Eigen::Vector2d scale = Eigen::Vector2d::Zero();
  for (int i = 0; i < 2; ++i) {
    const double length = std::sqrt(squares(i));
    if (length > least) scale(i) = 1 / length;
  }
  return scale.asDiagonal() * principal;
}

std::vector<Eigen::Vector2d> Mapped(const Eigen::Matrix2d& map,
                                    std::vector<Eigen::Vector2d> points) {
  for (Eigen::Vector2d& p : points) p = map * p;
  return points;
}

double Diameter(std::span<const Eigen::Vector2d> points) {
  double diameter = 0;
  for (const Eigen::Vector2d& a : points) {
    for (const Eigen::Vector2d& b : points) diameter = std::max(diameter, (a - b).norm());
  }
  return diameter;
}

/** A patch, its contacts and some points, seen along the normal and stretched to unit
 spread. */
struct Stretched {
  Eigen::Matrix2d map;
  std::vector<Eigen::Vector2d> corners;
  std::vector<Eigen::Vector2d> contacts;
  std::vector<Eigen::Vector2d> points;
};

Stretched StretchedAlong(const Eigen::Vector3d& n_AB_W, const ContactPatch& patch,
                         std::span<const ContactPoint> contacts,
                         std::span<const Eigen::Vector3d> points = {}) {
  std::vector<Eigen::Vector3d> positions;
  for (const ContactPoint& contact : contacts) positions.push_back(contact.p_WC);
  const std::vector<Eigen::Vector2d> plane = ProjectedAlong(n_AB_W, patch.vertices_W);
  const Eigen::Matrix2d map = Whitening(plane);
  return {map, Mapped(map, plane), Mapped(map, ProjectedAlong(n_AB_W, positions)),
          Mapped(map, ProjectedAlong(n_AB_W, points))};
}

/** Returns the largest distance of a point from the hull of the contacts, over the
 diameter of the patch. */
double LargestUnspanned(const Stretched& seen, std::span<const Eigen::Vector2d> points) {
  if (seen.contacts.empty()) return 1;
  const double diameter = Diameter(seen.corners);
  if (diameter == 0) return 0;
  const std::vector<Eigen::Vector2d> hull = ConvexHullOf(seen.contacts);
  double unspanned = 0;
  for (const Eigen::Vector2d& p : points)
    unspanned = std::max(unspanned, DistanceFrom(hull, p));
  return std::min(1.0, unspanned / diameter);
}

}  // namespace

double PatchUnspanned(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                      std::span<const ContactPoint> contacts) {
  const Stretched seen = StretchedAlong(n_AB_W, patch, contacts);
  return LargestUnspanned(seen, seen.corners);
}

double UnspannedAt(const Eigen::Vector3d& p_W, const ContactPatch& patch,
                   const Eigen::Vector3d& n_AB_W,
                   std::span<const ContactPoint> contacts) {
  const Stretched seen = StretchedAlong(n_AB_W, patch, contacts, std::span(&p_W, 1));
  return LargestUnspanned(seen, seen.points);
}

Eigen::Vector3d ShortfallAt(const Eigen::Vector3d& p_W, const ContactPatch& patch,
                            const Eigen::Vector3d& n_AB_W,
                            std::span<const ContactPoint> contacts) {
  const Stretched seen = StretchedAlong(n_AB_W, patch, contacts, std::span(&p_W, 1));
  const Eigen::Vector2d offset =
      OffsetFrom(ConvexHullOf(seen.contacts), seen.points.front());
  const double diameter = Diameter(seen.corners);
  if (offset.isZero(0) || diameter == 0) return Eigen::Vector3d::Zero();
  // Lengths along a unit vector of the stretched plane are those along the image of that
  // vector under the transposed map.
  const Eigen::Vector2d across = seen.map.transpose() * offset.normalized();
  return LiftedAcross(n_AB_W, across / diameter);
}

double PatchBlur(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W, double e) {
  const std::vector<Eigen::Vector2d> corners =
      ConvexHullOf(ProjectedAlong(n_AB_W, patch.vertices_W));
  if (corners.size() < 3) return 2 * e / Diameter(corners);
  double perimeter = 0;
  double twice_area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % corners.size()] - corners[i];
    const Eigen::Vector2d arm = corners[i] - corners[0];
    perimeter += side.norm();
    twice_area += arm.x() * side.y() - arm.y() * side.x();
  }
  return e * perimeter * 2 / twice_area;
}

double LegalUnspanned(const ContactPatch& patch, const Eigen::Vector3d& n_AB_W,
                      std::span<const ContactPoint> contacts) {
  if (patch.vertices_W.size() <= 4) return kLegalUnspanned;
  const Stretched seen = StretchedAlong(n_AB_W, patch, contacts);
  const std::vector<Eigen::Vector2d> rim = ConvexHullOf(seen.corners);
  const double near = kLegalUnspanned * Diameter(rim);
  const auto at_rim = std::count_if(
      seen.contacts.begin(), seen.contacts.end(),
      [&](const Eigen::Vector2d& p) { return DistanceFromRim(rim, p) <= near; });
  return at_rim < 3 ? kLegalUnspanned : MostLegalUnspanned(patch);
}

double MostLegalUnspanned(const ContactPatch& patch) {
  const std::size_t k = patch.vertices_W.size();
  if (k <= 4) return kLegalUnspanned;
  const bool is_disc = patch.least_contacts == 3;
  if (!is_disc) return kInscribedUnspanned;
  return 0.5 - 0.25 * std::cos(std::numbers::pi / static_cast<double>(k));
}

int ContactCountError(int least, std::span<const ContactPoint> contacts, double same) {
  int repeated = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto earlier = contacts.first(i);
    repeated += std::any_of(earlier.begin(), earlier.end(), [&](const ContactPoint& c) {
      return (c.p_WC - contacts[i].p_WC).norm() < same;
    });
  }
  const int missing = least - (static_cast<int>(contacts.size()) - repeated);
  return std::max({missing, repeated, 0});
}

namespace {

/** Why a patch that is left out proves nothing. */
constexpr std::string_view kNothingMissed =
    "no point that is certified to belong to it is missed";

/** What CheckExtent() has found. */
struct Extent {
  bool is_spanned = false;
  bool is_certain = true;  ///< Whether that is proved.
};

/** Judges whether the contacts span the patch of at least two vertices. */
Extent CheckExtent(JudgedAnswer& judged, const ContactPatch& patch,
                   const Eigen::Vector3d& n_W) {
  const std::vector<ContactPoint>& contacts = judged.answer.points;
  const double e = judged.tolerances.position;
  const double unspanned = PatchUnspanned(patch, n_W, contacts);
  const double legal = LegalUnspanned(patch, n_W, contacts);
  const double blur = PatchBlur(patch, n_W, e);
  const double tolerance = legal + blur;
  // If doubles overflow, nothing is proved.
  const bool is_spanned = unspanned <= tolerance || !std::isfinite(tolerance);
  std::optional<Eigen::Vector3d> missed;
  if (!is_spanned)
    missed = CertainlyMissed(judged.query, patch, n_W, judged.SupportedSeparation(),
                             contacts, tolerance, e);
  const auto because = [&] {
    return fmt::format("{}, and sides off by {:.2g} m leave {:.2g} of it",
                       legal > kLegalUnspanned
                           ? "a triangle inscribed in a disc leaves a quarter of its "
                             "diameter unspanned"
                           : "a sixteenth of its extent may be left unspanned",
                       e, blur);
  };
  judged.Judge({.measure = MeasureKind::kPatchCoverage,
                .value = unspanned,
                .tolerance = tolerance,
                .unproved = missed ? "" : kNothingMissed},
               because, [&]() -> Proof {
                 return {.kind = ProofKind::kUnspanned,
                         .rest = unspanned,
                         .points_W = {*missed},
                         .contacts = {contacts.size(), 0}};
               });
  return {is_spanned, is_spanned || missed.has_value()};
}

}  // namespace

void CheckCoverage(JudgedAnswer& judged) {
  const std::vector<ContactPoint>& contacts = judged.answer.points;
  const Enclosure& truth = judged.truth.separation;
  const double e = judged.tolerances.position;
  const bool applies = !contacts.empty() && judged.answer.touching &&
                       judged.normal_is_right && judged.capability.manifold &&
                       truth.hi - truth.lo <= judged.tolerances.separation &&
                       truth.hi < -2 * e;
  if (!applies) return;
  const Eigen::Vector3d n_W = SupportingDirection(judged.query, *judged.n_W);
  const ContactPatch patch = CertainPatch(judged.query, n_W, judged.SupportedSeparation(),
                                          judged.truth.input_rounding, e);
  const Extent extent =
      patch.vertices_W.size() > 1 ? CheckExtent(judged, patch, n_W) : Extent();
  // Contacts that are repeated are too many of any patch.
  const bool is_proved = extent.is_certain || ContactCountError(0, contacts, e) > 0;
  const int least = extent.is_spanned ? 0 : patch.least_contacts;
  judged.Judge(
      {.measure = MeasureKind::kContactCount,
       .value = static_cast<double>(ContactCountError(least, contacts, e)),
       .tolerance = 0,
       .unproved = is_proved ? "" : kNothingMissed},
      [] { return std::string("the patch needs that many"); },
      [&]() -> Proof {
        return {.kind = ProofKind::kCount,
                .contacts = {contacts.size(),
                             static_cast<std::uint64_t>(patch.least_contacts)}};
      });
}

}  // namespace touchstone
