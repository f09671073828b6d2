#include "tests/reports/contacts/altered_answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "reports/contacts/body_size.h"
#include "reports/contacts/checks/contact_surface_error.h"
#include "reports/contacts/checks/patch_coverage.h"
#include "reports/contacts/exact_scene.h"
#include "reports/referee/referee.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/referee/second_referee.h"

namespace touchstone {
namespace {

using Altered = std::optional<ContactAnswer>;

/** The ratio of an alteration to the accuracy of what it changes. */
constexpr double kClearly = 10;

bool HasHalfSpace(const ContactQuery& query) {
  return KindOf(query.A.shape) == ShapeKind::kHalfSpace ||
         KindOf(query.B.shape) == ShapeKind::kHalfSpace;
}

Eigen::Vector3d Middle(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
    middle += p / static_cast<double>(points.size());
  return middle;
}

std::vector<Eigen::Vector3d> PositionsOf(const ContactAnswer& answer) {
  std::vector<Eigen::Vector3d> positions;
  for (const ContactPoint& contact : answer.points) positions.push_back(contact.p_WC);
  return positions;
}

double Extent(std::span<const Eigen::Vector3d> points) {
  double extent = 0;
  for (const Eigen::Vector3d& p : points)
    extent = std::max(extent, (p - points[0]).norm());
  return extent;
}

/** Returns the ReachedCorners() of the patch along `n_W`. A corner that the question's
 own rounding tilts away counts as reached. Returns none if only one corner of several is:
 the patch is flush with a direction near `n_W`, and a right answer spans it. */
std::vector<Eigen::Vector3d> PatchPoints(const ContactQuery& query,
                                         const ContactTruth& truth,
                                         const Eigen::Vector3d& n_W, double separation,
                                         const Accuracy& accuracy) {
  const double e = accuracy.length;
  const ContactPatch patch = PatchAlong(query, n_W, separation, e);
  std::vector<Eigen::Vector3d> points = ReachedCorners(
      query, patch, n_W, separation, std::max(0.75 * e, truth.input_rounding));
  if (points.size() == 1 && patch.vertices_W.size() > 1) return {};
  return points;
}

/** Roundings of the scene's size that a right answer may be off by: a separating-axis
 test in the frame of a body costs 54.5 (reports/contacts/tolerances.h has the sum),
 stated here again so that a change there is seen. [-] */
constexpr double kAccurateRoundings = 64;

/** Returns a number of either sign whose magnitude is log-uniform from kClearly times
 `accuracy` to `most`; empty if there is none. */
std::optional<double> ClearlyBeyond(double accuracy, double most, RandomScene& random) {
  const double least = kClearly * accuracy;
  if (!(least < most)) return std::nullopt;
  const double amount = least * std::pow(most / least, random.Uniform(0, 1));
  return random.Uniform(0, 1) < 0.5 ? -amount : amount;
}

/** Returns a unit vector across `n`. */
Eigen::Vector3d Across(const Eigen::Vector3d& n, RandomScene& random) {
  const Eigen::Vector3d u = n.unitOrthogonal();
  const double turn = random.Uniform(0, 2 * M_PI);
  return std::cos(turn) * u + std::sin(turn) * n.cross(u);
}

std::size_t Any(std::size_t count, RandomScene& random) {
  return static_cast<std::size_t>(random.Uniform(0, 1) * static_cast<double>(count));
}

/** Returns whether the patch is so wide that leaving half of it out must be seen: its
 extent and its blur are far beyond the accuracy, see PatchBlur(). */
bool MustSpan(const RightlyAnswered& q) {
  if (!q.right.touching || q.right.points.size() < 2) return false;
  // Shallower patches need not be covered.
  if (*q.right.separation > -kClearly * q.accuracy.length) return false;
  const ContactPatch patch = CertainPatch(q.query, *q.right.n_AB_W, *q.right.separation,
                                          q.truth.input_rounding, q.accuracy.length);
  return patch.vertices_W.size() > 1 &&
         Extent(patch.vertices_W) > kClearly * q.accuracy.across &&
         PatchBlur(patch, *q.right.n_AB_W, q.accuracy.length) < 0.01;
}

Altered OtherTouching(const RightlyAnswered& q, RandomScene&) {
  const double s = std::abs(*q.right.separation);
  if (q.truth.touching == Touching::kUndecided || s < kClearly * q.accuracy.length)
    return std::nullopt;
  ContactAnswer answer = q.right;
  answer.touching = !answer.touching;
  return answer;
}

Altered OtherSeparation(const RightlyAnswered& q, RandomScene& random) {
  const auto by = ClearlyBeyond(q.accuracy.length, q.accuracy.fine * 100, random);
  if (!by) return std::nullopt;
  ContactAnswer answer = q.right;
  *answer.separation += *by;
  return answer;
}

Altered RotatedNormal(const RightlyAnswered& q, RandomScene& random) {
  if (!q.right.touching) return std::nullopt;
  const double angle = M_PI * random.Power(-7, 0);
  ContactAnswer answer = q.right;
  const Eigen::Vector3d n =
      Eigen::AngleAxisd(angle, Across(*q.right.n_AB_W, random)) * *q.right.n_AB_W;
  answer.n_AB_W = n.normalized();
  // A half-space is never left along another direction, but only a tilt that is not a
  // rounding counts.
  const bool plane = HasHalfSpace(q.query);
  const double excess =
      plane ? angle * SmallerExtent(q.query)
            : static_cast<double>(-GapAlong(q.query, n) + Wide(q.truth.separation.lo));
  const double tolerance = std::max(q.accuracy.excess, q.accuracy.apart);
  if (excess < kClearly * tolerance) return std::nullopt;
  if (plane && angle < kClearly * tolerance / SmallestFeature(q.query))
    return std::nullopt;
  return answer;
}

Altered FlippedNormal(const RightlyAnswered& q, RandomScene&) {
  ContactAnswer answer = q.right;
  *answer.n_AB_W *= -1;
  const bool plane = HasHalfSpace(q.query);
  if (plane && kClearly * q.accuracy.apart < SmallestFeature(q.query)) return answer;
  if (plane) return std::nullopt;
  const double excess = static_cast<double>(-GapAlong(q.query, *answer.n_AB_W) +
                                            Wide(q.truth.separation.lo));
  if (excess < kClearly * q.accuracy.excess) return std::nullopt;
  return answer;
}

Altered ContactOffTheSurfaces(const RightlyAnswered& q, RandomScene& random) {
  if (!q.right.touching) return std::nullopt;
  const auto by = ClearlyBeyond(q.accuracy.length, q.accuracy.fine * 10, random);
  if (!by) return std::nullopt;
  ContactAnswer answer = q.right;
  ContactPoint& contact = answer.points[Any(answer.points.size(), random)];
  contact.p_WC += *by * *answer.n_AB_W;
  return answer;
}

Altered ContactOffThePatch(const RightlyAnswered& q, RandomScene& random) {
  if (!q.right.touching) return std::nullopt;
  const auto by = ClearlyBeyond(q.accuracy.across, q.accuracy.fine * 50, random);
  if (!by) return std::nullopt;
  ContactAnswer answer = q.right;
  const Eigen::Vector3d middle = Middle(PositionsOf(answer));
  ContactPoint& contact = answer.points[Any(answer.points.size(), random)];
  const Eigen::Vector3d out = contact.p_WC - middle;
  const Eigen::Vector3d direction = out.norm() > *by ? Eigen::Vector3d(out.normalized())
                                                     : Across(*answer.n_AB_W, random);
  contact.p_WC += std::abs(*by) * direction;
  // Another place may be as deep: a curved body, or a patch without corners there.
  const WitnessPoints on = SurfacePointsOf(contact, *answer.n_AB_W);
  if (SurfaceError(q.query, on) < kClearly * q.accuracy.length) return std::nullopt;
  return answer;
}

Altered ContactOfOtherDepth(const RightlyAnswered& q, RandomScene& random) {
  if (!q.right.touching) return std::nullopt;
  // Half of the change appears at either body.
  const auto by = ClearlyBeyond(2 * q.accuracy.length, q.accuracy.fine * 10, random);
  if (!by) return std::nullopt;
  ContactAnswer answer = q.right;
  ContactPoint& contact = answer.points[Any(answer.points.size(), random)];
  contact.separation += *by;
  // Sides along the normal keep both points on the surfaces. Only the bodies' extent
  // beyond them tells, which counts from the tolerance across the normal.
  const WitnessPoints on = SurfacePointsOf(contact, *answer.n_AB_W);
  if (SurfaceError(q.query, on) < kClearly * q.accuracy.length &&
      std::abs(*by) < 2 * kClearly * q.accuracy.across)
    return std::nullopt;
  return answer;
}

Altered ExchangedWitnesses(const RightlyAnswered& q, RandomScene&) {
  if (std::abs(*q.right.separation) < kClearly * q.accuracy.apart) return std::nullopt;
  ContactAnswer answer = q.right;
  std::swap(answer.witnesses->p_WCa, answer.witnesses->p_WCb);
  return answer;
}

Altered WitnessMovedAlong(const RightlyAnswered& q, RandomScene& random) {
  const auto by = ClearlyBeyond(3 * q.accuracy.length, q.accuracy.fine * 10, random);
  if (!by) return std::nullopt;
  ContactAnswer answer = q.right;
  answer.witnesses->p_WCb += *by * *answer.n_AB_W;
  return answer;
}

Altered NoWitnesses(const RightlyAnswered& q, RandomScene&) {
  ContactAnswer answer = q.right;
  answer.witnesses.reset();
  return answer;
}

Altered DrawnToTheMiddle(const RightlyAnswered& q, RandomScene& random) {
  if (!MustSpan(q)) return std::nullopt;
  ContactAnswer answer = q.right;
  const Eigen::Vector3d middle = Middle(PositionsOf(answer));
  const double drawn = random.Uniform(0, 0.5);
  for (ContactPoint& c : answer.points) c.p_WC = middle + drawn * (c.p_WC - middle);
  return answer;
}

Altered DroppedContacts(const RightlyAnswered& q, RandomScene& random) {
  if (!MustSpan(q)) return std::nullopt;
  ContactAnswer answer = q.right;
  // Five corners may be spanned by four contacts; one contact spans no patch.
  const auto keep = static_cast<std::ptrdiff_t>(
      answer.points.size() > 4 ? 1 : answer.points.size() - 1);
  std::rotate(answer.points.begin(),
              answer.points.begin() +
                  static_cast<std::ptrdiff_t>(Any(answer.points.size(), random)),
              answer.points.end());
  answer.points.erase(answer.points.begin() + keep, answer.points.end());
  // A corner may be so near to its neighbours that nothing is lost.
  const ContactPatch patch = CertainPatch(q.query, *q.right.n_AB_W, *q.right.separation,
                                          q.truth.input_rounding, q.accuracy.length);
  if (PatchUnspanned(patch, *q.right.n_AB_W, answer.points) < 0.2) return std::nullopt;
  return answer;
}

Altered AllContactsDropped(const RightlyAnswered& q, RandomScene&) {
  if (!q.right.touching) return std::nullopt;
  ContactAnswer answer = q.right;
  answer.points.clear();
  return answer;
}

Altered SurplusContact(const RightlyAnswered& q, RandomScene& random) {
  if (!q.right.touching) return std::nullopt;
  const auto by = ClearlyBeyond(q.accuracy.length, q.accuracy.fine * 50, random);
  if (!by) return std::nullopt;
  ContactAnswer answer = q.right;
  ContactPoint added = answer.points[Any(answer.points.size(), random)];
  added.separation = std::abs(*by);
  answer.points.push_back(added);
  return answer;
}

Altered RepeatedContact(const RightlyAnswered& q, RandomScene& random) {
  if (!q.right.touching || *q.right.separation > -kClearly * q.accuracy.length)
    return std::nullopt;
  ContactAnswer answer = q.right;
  answer.points.push_back(answer.points[Any(answer.points.size(), random)]);
  return answer;
}

Altered OneContactFlipped(const RightlyAnswered& q, RandomScene& random) {
  if (!q.right.touching) return std::nullopt;
  ContactAnswer answer = q.right;
  answer.points[Any(answer.points.size(), random)].n_AB_W = -*answer.n_AB_W;
  return answer;
}

Altered NotANumber(const RightlyAnswered& q, RandomScene& random) {
  ContactAnswer answer = q.right;
  const double nan = std::nan("");
  switch (Any(3, random)) {
    case 0:
      answer.separation = nan;
      break;
    case 1:
      answer.n_AB_W->y() = nan;
      break;
    default:
      answer.witnesses->p_WCa.x() = nan;
  }
  return answer;
}

constexpr std::array kWrong = {
    Alteration{"touching negated", OtherTouching},
    Alteration{"separation changed", OtherSeparation},
    Alteration{"normal rotated", RotatedNormal},
    Alteration{"normal flipped", FlippedNormal},
    Alteration{"contact moved along the normal", ContactOffTheSurfaces},
    Alteration{"contact moved off the patch", ContactOffThePatch},
    Alteration{"depth of one contact changed", ContactOfOtherDepth},
    Alteration{"normal of one contact flipped", OneContactFlipped},
    Alteration{"witness points exchanged", ExchangedWitnesses},
    Alteration{"witness point moved", WitnessMovedAlong},
    Alteration{"witness points left out", NoWitnesses},
    Alteration{"contacts drawn to the middle", DrawnToTheMiddle},
    Alteration{"contacts dropped", DroppedContacts},
    Alteration{"all contacts dropped", AllContactsDropped},
    Alteration{"surplus contact", SurplusContact},
    Alteration{"contact repeated", RepeatedContact},
    Alteration{"not a number", NotANumber},
};

Altered AsItIs(const RightlyAnswered& q, RandomScene&) {
  return q.right;
}

Altered Rounded(const RightlyAnswered& q, RandomScene& random) {
  ContactAnswer answer = q.right;
  const double ulp = 2 * q.unit_roundoff * SceneSize(q.query);
  const auto round = [&](Eigen::Vector3d& p) { p += random.Point(4 * ulp); };
  *answer.separation += random.Uniform(-4, 4) * ulp;
  if (answer.touching != (*answer.separation <= 0)) return std::nullopt;
  *answer.n_AB_W += random.Point(4 * q.unit_roundoff);
  round(answer.witnesses->p_WCa);
  round(answer.witnesses->p_WCb);
  for (ContactPoint& contact : answer.points) {
    round(contact.p_WC);
    contact.separation = *answer.separation;
  }
  return answer;
}

Altered Reordered(const RightlyAnswered& q, RandomScene& random) {
  if (q.right.points.size() < 2) return std::nullopt;
  ContactAnswer answer = q.right;
  for (std::size_t i = answer.points.size() - 1; i > 0; --i)
    std::swap(answer.points[i], answer.points[Any(i + 1, random)]);
  return answer;
}

Altered MoreContacts(const RightlyAnswered& q, RandomScene& random) {
  if (q.right.points.size() < 2 ||
      Extent(PositionsOf(q.right)) < kClearly * q.accuracy.across)
    return std::nullopt;
  ContactAnswer answer = q.right;
  ContactPoint added = answer.points[0];
  const std::size_t other = 1 + Any(answer.points.size() - 1, random);
  added.p_WC += random.Uniform(0.2, 0.8) * (answer.points[other].p_WC - added.p_WC);
  answer.points.push_back(added);
  return answer;
}

Altered DrawnInByLittle(const RightlyAnswered& q, RandomScene& random) {
  if (q.right.points.size() < 2 || q.right.points.size() > 4) return std::nullopt;
  ContactAnswer answer = q.right;
  const Eigen::Vector3d middle = Middle(PositionsOf(answer));
  const double drawn = random.Uniform(0.97, 1);
  for (ContactPoint& c : answer.points) c.p_WC = middle + drawn * (c.p_WC - middle);
  return answer;
}

Altered OtherWitnesses(const RightlyAnswered& q, RandomScene& random) {
  const Eigen::Vector3d& n_W = *q.right.n_AB_W;
  const std::vector<Eigen::Vector3d> points =
      PatchPoints(q.query, q.truth, n_W, *q.right.separation, q.accuracy);
  if (points.size() < 2) return std::nullopt;
  Eigen::Vector3d p_W = points[0];
  for (const Eigen::Vector3d& p : points) p_W += random.Uniform(0, 1) * (p - p_W);
  ContactAnswer answer = q.right;
  answer.witnesses = SurfacePointsOf({p_W, *answer.separation, {}}, n_W);
  return answer;
}

Altered FieldsInContactsOnly(const RightlyAnswered& q, RandomScene&) {
  if (!q.right.touching) return std::nullopt;
  ContactAnswer answer = q.right;
  for (ContactPoint& contact : answer.points) contact.n_AB_W = answer.n_AB_W;
  answer.n_AB_W.reset();
  answer.separation.reset();
  return answer;
}

/** The answer along another direction that is as short: the opposite one, or one that the
 symmetry of a body offers. */
Altered OtherTie(const RightlyAnswered& q, RandomScene& random) {
  // A half-space is left along its own normal only.
  if (!q.right.touching || HasHalfSpace(q.query)) return std::nullopt;
  const Eigen::Matrix3d& R =
      (random.Uniform(0, 1) < 0.5 ? q.query.A : q.query.B).X_WB.R_WB;
  const Eigen::Vector3d n_B = R.transpose() * *q.right.n_AB_W;
  Eigen::Vector3d m_B = n_B;
  switch (Any(3, random)) {
    case 0:
      m_B = -n_B;
      break;
    case 1:
      m_B = {n_B.y(), n_B.z(), n_B.x()};
      break;
    default:
      m_B =
          Eigen::AngleAxisd(random.Uniform(0, 2 * M_PI), Eigen::Vector3d::UnitZ()) * n_B;
  }
  const Eigen::Vector3d m_W = (R * m_B).normalized();
  if ((m_W - *q.right.n_AB_W).norm() < 1e-6) return std::nullopt;
  const Enclosure overlap = Overlap(q.query, m_W);
  if (!(overlap.hi + q.truth.separation.hi < q.accuracy.length / 8)) return std::nullopt;
  ContactAnswer answer = q.right;
  answer.n_AB_W = m_W;
  answer.points.clear();
  for (const Eigen::Vector3d& p_W :
       PatchPoints(q.query, q.truth, m_W, -overlap.lo, q.accuracy))
    answer.points.push_back({p_W, *answer.separation, {}});
  if (answer.points.empty()) return std::nullopt;
  answer.witnesses = SurfacePointsOf(answer.points.front(), m_W);
  return answer;
}

constexpr std::array kLegal = {
    Alteration{"as it is", AsItIs},
    Alteration{"rounded", Rounded},
    Alteration{"contacts reordered", Reordered},
    Alteration{"contacts added between", MoreContacts},
    Alteration{"contacts drawn in by 3 %", DrawnInByLittle},
    Alteration{"other witness points", OtherWitnesses},
    Alteration{"fields in the contacts only", FieldsInContactsOnly},
    Alteration{"another direction as short", OtherTie},
};

}  // namespace

Accuracy AccuracyOf(const ContactQuery& query, const ContactTruth& truth,
                    double unit_roundoff) {
  Accuracy accuracy;
  const double e =
      kAccurateRoundings * unit_roundoff * SceneSize(query) + truth.input_rounding;
  accuracy.length = e;
  const double distance = truth.separation.lo;
  const double extents =
      SumOfExtents(query) + (HasHalfSpace(query) ? 2 * SceneSize(query) : 0);
  accuracy.apart = distance > 0 ? e + extents * std::min(1.0, e / distance) : e;
  accuracy.excess = accuracy.apart + e;
  const double extent = SmallerExtent(query);
  accuracy.across = std::min(std::sqrt(8 * e * extent), extent);
  accuracy.fine = 0.01 * (SmallestFeature(query) + std::max(0.0, distance));
  return accuracy;
}

std::optional<ContactAnswer> RightAnswerOf(const ContactQuery& query,
                                           const ContactTruth& truth,
                                           const Accuracy& accuracy) {
  const Enclosure& e = truth.separation;
  if (e.hi - e.lo > accuracy.length / 8) return std::nullopt;
  if (accuracy.length > accuracy.fine) return std::nullopt;
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.separation = e.lo + (e.hi - e.lo) / 2;
  const auto exact =
      IsExactScene(query, 0x1p-53) ? TouchingInExactScene(query, truth) : std::nullopt;
  answer.touching = exact.value_or(*answer.separation <= 0);
  answer.n_AB_W = truth.certificate.n_AB_W.normalized();
  answer.witnesses = {truth.certificate.p_WCa, truth.certificate.p_WCb};
  if (!answer.touching) return answer;
  for (const Eigen::Vector3d& p_W :
       PatchPoints(query, truth, *answer.n_AB_W, *answer.separation, accuracy)) {
    answer.points.push_back({p_W, *answer.separation, {}});
  }
  if (answer.points.empty()) return std::nullopt;
  answer.witnesses = SurfacePointsOf(answer.points.front(), *answer.n_AB_W);
  return answer;
}

std::span<const Alteration> WrongAlterations() {
  return kWrong;
}

std::span<const Alteration> LegalAlterations() {
  return kLegal;
}

}  // namespace touchstone
