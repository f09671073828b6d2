#include "reports/finding/proof.h"

#include <cmath>

#include <fmt/format.h>

#include "reports/text/counted.h"
#include "reports/text/format_vector.h"
#include "reports/text/quoted_name.h"
#include "reports/text/told_apart.h"

namespace touchstone {
namespace {

constexpr int kDigits = 9;

std::string InMetres(double length) {
  return fmt::format("{:.{}g}", length, kDigits);
}

/** Returns whether a certificate is about bodies that are apart. */
bool IsOfGap(ProofKind kind) {
  return kind == ProofKind::kPlane || kind == ProofKind::kNearestPoints;
}

/** Returns whether claim and certificate are lengths of one kind, two gaps or two depths,
 whose difference says something. */
bool IsCompared(const Proof& proof) {
  switch (proof.claim) {
    case ProofClaim::kNormal:
      return true;
    case ProofClaim::kSeparation:
    case ProofClaim::kContact:
      return (proof.said < 0) != IsOfGap(proof.kind);
    default:
      return false;
  }
}

/** Returns the claim, with `said` as the text of its length. */
std::string ClaimInWords(const Proof& proof, std::string_view said) {
  const std::string_view deep_or_apart = proof.said < 0 ? "deep" : "apart";
  switch (proof.claim) {
    case ProofClaim::kNone:
      return "";
    case ProofClaim::kTouching:
      return "says they touch";
    case ProofClaim::kApart:
      return "says apart";
    case ProofClaim::kSeparation:
      return fmt::format("says {} m {}", said, deep_or_apart);
    case ProofClaim::kNormal:
      return fmt::format("says n = {}, along which {} {} m",
                         FormatVector(proof.claimed_W),
                         IsOfGap(proof.kind) ? "the gap is" : "B must move", said);
    case ProofClaim::kContact:
      return fmt::format("returns a contact {} m {} at {}", said, deep_or_apart,
                         FormatVector(proof.points_W[0]));
  }
  return "";
}

/** Returns the certificate, with `bound` as the text of its length. */
std::string CertificateInWords(const Proof& proof, std::string_view bound) {
  switch (proof.kind) {
    case ProofKind::kPlane:
      return fmt::format("the plane n·x = {} with n = {} separates them by {} m",
                         proof.offset, FormatVector(proof.n_W), bound);
    case ProofKind::kTranslation:
      return fmt::format("moving B by {} m along {} separates them", bound,
                         FormatVector(proof.n_W));
    case ProofKind::kNoTranslation:
      return fmt::format("no translation shorter than {} m separates them", bound);
    case ProofKind::kCommonPoint:
      return proof.bound < 0 ? fmt::format("the point {} lies {} m inside both",
                                           FormatVector(proof.points_W[0]), bound)
                             : fmt::format("the point {} belongs to both",
                                           FormatVector(proof.points_W[0]));
    default:
      return fmt::format("the point {} of A and the point {} of B are {} m apart",
                         FormatVector(proof.points_W[0]), FormatVector(proof.points_W[1]),
                         bound);
  }
}

std::string Certified(const Proof& proof) {
  const double sign = IsOfGap(proof.kind) ? 1 : -1;
  // The sum makes 0 of −0.
  const double said = sign * proof.said + 0.0;
  const double bound = sign * proof.bound + 0.0;
  const bool compared = IsCompared(proof);
  const ToldApart told = compared
                             ? TellApart(said, bound, kDigits)
                             : ToldApart{InMetres(std::abs(said)), InMetres(bound), ""};
  std::string words = fmt::format("{}; {}", ClaimInWords(proof, told.a),
                                  CertificateInWords(proof, told.b));
  if (compared) {
    words += fmt::format(", {} m {}", told.difference, bound > said ? "more" : "less");
  }
  if (proof.kind == ProofKind::kNoTranslation && !proof.claimed_W.isZero(0)) {
    words += fmt::format(
        "; moving B by {} m along its own normal {} leaves an overlap of {} m", told.a,
        FormatVector(proof.claimed_W), InMetres(proof.rest));
  }
  return words;
}

/** Returns "(0, 0, 1) of A and (0, 0, 2) of B", with `of` before the body's name. */
std::string OnBoth(const Proof& proof, std::string_view of) {
  return fmt::format("{} {} A and {} {} B", FormatVector(proof.points_W[0]), of,
                     FormatVector(proof.points_W[1]), of);
}

std::string WitnessesInWords(const Proof& proof) {
  const std::string says = fmt::format("says {} and a separation of {} m",
                                       OnBoth(proof, "of"), InMetres(proof.said));
  if (proof.claimed_W.isZero(0)) {
    const auto [length, said, off] =
        TellApart(proof.bound, std::abs(proof.said), kDigits);
    return fmt::format("{}; the points are {} m apart: a difference of {} m", says,
                       length, off);
  }
  return fmt::format(
      "{} along n = {}; from the first point to the second it is {} m along n and {} m "
      "across",
      says, FormatVector(proof.claimed_W), TellApart(proof.bound, proof.said, kDigits).a,
      InMetres(proof.rest));
}

/** Returns a signed separation as text: "0.05 m deep", "0.01 m apart". */
std::string DeepOrApart(std::string_view separation) {
  return separation.starts_with('-') ? fmt::format("{} m deep", separation.substr(1))
                                     : fmt::format("{} m apart", separation);
}

/** Returns what the answers to a question and to its variant say. */
std::string VariantInWords(const Proof& proof) {
  if (proof.kind == ProofKind::kVariantTouch) {
    return fmt::format(
        "says {}; for its variant ({}) it says {}: the separation is certified to be "
        "{:.3g} m from touching",
        proof.touching ? "touching" : "apart", proof.change,
        proof.touching ? "apart" : "touching", proof.bound);
  }
  const auto [said, other, difference] = TellApart(proof.said, proof.bound, kDigits);
  if (proof.kind == ProofKind::kVariantSeparation) {
    return fmt::format(
        "says {}; for its variant ({}), mapped back, it says {}: a difference of {} m",
        DeepOrApart(said), proof.change, DeepOrApart(other), difference);
  }
  return fmt::format(
      "says n = {}, along which max_A n·x − min_B n·x is {} m; for its variant ({}), "
      "mapped back, it says n = {}, along which that is {} m: a difference of {} m",
      FormatVector(proof.claimed_W), said, proof.change, FormatVector(proof.n_W), other,
      difference);
}

/** Returns what the oracle does, without its name and without a stop. */
std::string Predicate(const Proof& proof) {
  switch (proof.kind) {
    case ProofKind::kNone:
    case ProofKind::kPlaces:
      return "";
    case ProofKind::kPlane:
    case ProofKind::kTranslation:
    case ProofKind::kNoTranslation:
    case ProofKind::kCommonPoint:
    case ProofKind::kNearestPoints:
      return Certified(proof);
    case ProofKind::kOverlap: {
      const auto [said, along, difference] =
          TellApart(-proof.said, -proof.bound, kDigits);
      return fmt::format("says {} m along {}; the overlap along it is {} m, {} m {}",
                         said, FormatVector(proof.claimed_W), along, difference,
                         proof.bound < proof.said ? "more" : "less");
    }
    case ProofKind::kOpposite:
      return fmt::format(
          "says n = {}, which points from B to A: the opposite direction separates them "
          "by {} m, and along n itself they overlap by {} m",
          FormatVector(proof.claimed_W), InMetres(proof.said), InMetres(-proof.bound));
    case ProofKind::kDeepest: {
      const auto [said, found, difference] = TellApart(proof.said, proof.bound, kDigits);
      return fmt::format(
          "says a separation of {} m; that of its deepest contact, at {}, is {} m: a "
          "difference of {} m",
          said, FormatVector(proof.points_W[0]), found, difference);
    }
    case ProofKind::kWitnesses:
      return WitnessesInWords(proof);
    case ProofKind::kDuality: {
      const auto [said, gap, less] = TellApart(proof.said, proof.bound, kDigits);
      return fmt::format(
          "says {} are nearest; they are {} m apart, but the gap along their direction "
          "is {} m, {} m less",
          OnBoth(proof, "of"), said, gap, less);
    }
    case ProofKind::kOffSurfaces:
      return fmt::format(
          "puts its points at {}; these are {} m and {} m from the surfaces",
          OnBoth(proof, "on"), InMetres(proof.said), InMetres(proof.bound));
    case ProofKind::kTooShallow:
      return fmt::format(
          "puts a contact at {}; there a body extends {} m further along the normal",
          OnBoth(proof, "on"), InMetres(proof.bound));
    case ProofKind::kSurplus:
      return fmt::format(
          "returns a contact at {}, which are {} m apart: nothing touches there",
          OnBoth(proof, "on"), InMetres(proof.bound));
    case ProofKind::kOffPatch:
      return fmt::format(
          "puts a contact {} m deep at {}; the shapes overlap that deep only {} m from "
          "there, across the normal",
          InMetres(-proof.said), FormatVector(proof.points_W[0]), InMetres(proof.bound));
    case ProofKind::kUnspanned:
      return fmt::format(
          "returns {}, which leaves {:.0f} % of the patch's extent unspanned; both "
          "bodies reach as deep at {}",
          Counted(proof.contacts[0], "contact"), 100 * proof.rest,
          FormatVector(proof.points_W[0]));
    case ProofKind::kCount:
      return fmt::format("returns {}; {} would span the patch",
                         Counted(proof.contacts[0], "contact"),
                         Counted(proof.contacts[1], "different one"));
    case ProofKind::kMixedNormals:
      return fmt::format("returns normals {:.9g} rad apart in one manifold", proof.rest);
    case ProofKind::kVariantNormal:
    case ProofKind::kVariantSeparation:
    case ProofKind::kVariantTouch: {
      std::string words = VariantInWords(proof);
      if (!(proof.explained > 0)) return words;
      return fmt::format(
          "{}, of which the motion itself explains up to {:.3g} m, and {:.3g} m are left",
          words, proof.explained, proof.rest);
    }
  }
  return "";
}

/** Returns e.g. "at 1.35 s “ball” is at (0, 1, 0) and (0, 1, 0.5), 0.5 m and 3 rad
 apart". Places that differ are written with digits that show it. */
std::string PlacesInWords(const Proof& proof) {
  const Eigen::Vector3d& p = proof.points_W[0];
  const Eigen::Vector3d& q = proof.points_W[1];
  const double distance = (p - q).norm();
  const ToldApart told = TellApart(p, q, kDigits);
  std::string apart;
  if (distance > 0) apart = fmt::format(", {:.6g} m", distance);
  if (proof.rest > 0)
    apart += fmt::format("{}{:.6g} rad", apart.empty() ? ", " : " and ", proof.rest);
  if (!apart.empty()) apart += " apart";
  return fmt::format("at {:.6g} s {} is at {} and {}{}", proof.time,
                     QuotedName(proof.body), told.a, told.b, apart);
}

}  // namespace

std::string InWords(const Proof& proof, std::string_view oracle) {
  if (proof.kind == ProofKind::kPlaces) return PlacesInWords(proof);
  if (proof.kind == ProofKind::kNone) return "";
  return fmt::format("{} {}.", oracle, Predicate(proof));
}

std::string_view NameOf(ProofKind kind) {
  constexpr std::array<std::string_view, 22> kNames = {"",
                                                       "plane",
                                                       "translation",
                                                       "no translation",
                                                       "common point",
                                                       "nearest points",
                                                       "overlap",
                                                       "opposite",
                                                       "deepest",
                                                       "witnesses",
                                                       "duality",
                                                       "off surfaces",
                                                       "too shallow",
                                                       "surplus",
                                                       "off patch",
                                                       "unspanned",
                                                       "count",
                                                       "mixed normals",
                                                       "variant normal",
                                                       "variant separation",
                                                       "variant touch",
                                                       "places"};
  static_assert(kNames.size() == static_cast<std::size_t>(ProofKind::kPlaces) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view NameOf(ProofClaim claim) {
  constexpr std::array<std::string_view, 6> kNames = {
      "", "touching", "apart", "separation", "normal", "contact"};
  static_assert(kNames.size() == static_cast<std::size_t>(ProofClaim::kContact) + 1);
  return kNames[static_cast<std::size_t>(claim)];
}

}  // namespace touchstone
