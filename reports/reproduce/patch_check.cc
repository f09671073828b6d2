#include "reports/reproduce/patch_check.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "reports/contacts/checks/contact_off_patch.h"
#include "reports/contacts/checks/missed_point.h"
#include "reports/contacts/checks/patch_coverage.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/overlap_along.h"
#include "reports/measures/stated.h"
#include "reports/referee/referee.h"
#include "reports/reproduce/contact_check.h"
#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/surface_text.h"

namespace touchstone {
namespace {

/** A normal that differs by more is another one. Below it only the rounding of an engine
 that was built differently changes, or the normal is wrong itself: tilting a face by so
 little costs less than a millionth of its extent. [-] */
constexpr double kSameNormal = 1e-6;

Eigen::Vector3d NormalToJudge(const ContactAnswer& answer) {
  if (const auto n_W = NormalOf(answer)) return *n_W;
  throw CannotReproduce("the answer has no normal, to which a contact patch belongs");
}

/** A recorded answer whose patch is examined. */
struct Examined {
  explicit Examined(const FaultSubject& subject)
      : query(subject.scenario.contact),
        answer(subject.answer),
        tolerances(TolerancesOf(subject.oracle, subject.scenario, subject.truth,
                                subject.answer.touching)),
        stated_W(NormalToJudge(subject.answer)),
        n_W(SupportingDirection(query, stated_W)) {
    const Enclosure overlap = Overlap(query, n_W);
    separation = -(overlap.lo + (overlap.hi - overlap.lo) / 2);
  }

  const ContactQuery& query;
  const ContactAnswer& answer;
  Tolerances tolerances;
  Eigen::Vector3d stated_W;  ///< Unit normal of the answer.
  Eigen::Vector3d n_W;       ///< Unit normal of the patch: of a half-space, its own.
  double separation = 0;     ///< Along n_W. [m]
};

FaultCheck CheckAlong(const Eigen::Vector3d& stated_W) {
  FaultCheck check;
  check.applies = "answer.touching && IsAsBefore(answer.n)";
  check.applies_to = fmt::format("touching along the normal ({})", Literals(stated_W));
  check.definitions =
      VectorText() + fmt::format(R"(
// Whether n is the normal of the answer when this was written: what follows is about the
// contact patch of that normal.
bool IsAsBefore(const Vector& n) {{
  const Vector before = {{{}}};
  return std::hypot(n[0] - before[0], n[1] - before[1], n[2] - before[2]) <= {};
}}
)",
                                 Literals(stated_W), Literal(kSameNormal));
  return check;
}

/** Returns lines of a comment with the corners of `patch`. */
std::string CornersText(const ContactPatch& patch) {
  std::string text;
  for (const Eigen::Vector3d& corner : patch.vertices_W)
    text += fmt::format("  //   ({})\n", Literals(corner));
  return text;
}

[[noreturn]] void Refuse(const FaultSubject& subject) {
  throw CannotReproduce(fmt::format(
      "no point of the contact patch proves {} by itself: a program compares the "
      "contacts with one point, along one direction",
      NameOf(subject.finding.measure)));
}

/** A point of the patch that the contacts of the recorded answer leave out. */
struct Missed {
  Eigen::Vector3d p_W;
  Eigen::Vector3d shortfall_W;  ///< See ShortfallAt(). [1/m]
  double unspanned;  ///< The least of shortfall·(p − c) over the contacts. [-]
  double blur;       ///< See PatchBlur(). [-]
  int least_contacts;
  /** The fraction that three contacts or more may leave out, wherever they lie. [-] */
  double legal_of_three;
};

/** Returns the point that proves the largest share of `patch` to be left out, or nothing
 if none proves more than is legal. */
std::optional<Missed> FindMissed(const FaultSubject& subject, const Examined& examined) {
  const double e = examined.tolerances.position;
  const Eigen::Vector3d& n_W = examined.n_W;
  const std::vector<ContactPoint>& contacts = examined.answer.points;
  const ContactPatch patch = CertainPatch(examined.query, n_W, examined.separation,
                                          subject.truth.input_rounding, e);
  if (patch.vertices_W.size() < 2 || contacts.empty()) return std::nullopt;
  const double blur = PatchBlur(patch, n_W, e);
  const double legal = LegalUnspanned(patch, n_W, contacts) + blur;
  const auto find = [&](double least) {
    return CertainlyMissed(examined.query, patch, n_W, examined.separation, contacts,
                           least, e);
  };
  // The corner that is left out the farthest, to within a rounding, gives the value of
  // the finding.
  constexpr double kNearlyAll = 1 - 0x1p-40;
  std::optional<Eigen::Vector3d> p_W =
      find(std::max(legal, kNearlyAll * PatchUnspanned(patch, n_W, contacts)));
  if (!p_W) p_W = find(legal);
  if (!p_W) return std::nullopt;
  Missed missed{.p_W = *p_W,
                .shortfall_W = ShortfallAt(*p_W, patch, n_W, contacts),
                .unspanned = 1,
                .blur = blur,
                .least_contacts = patch.least_contacts,
                .legal_of_three = MostLegalUnspanned(patch)};
  for (const ContactPoint& contact : contacts) {
    missed.unspanned =
        std::min(missed.unspanned, missed.shortfall_W.dot(*p_W - contact.p_WC));
  }
  const double allowed =
      blur + (contacts.size() < 3 ? kLegalUnspanned : missed.legal_of_three);
  if (!(missed.unspanned > allowed)) return std::nullopt;
  return missed;
}

/** Writes `LegallyUnspanned()` and `unspanned`, the share of the patch that the contacts
 leave out at the missed point at least. */
void WriteUnspanned(const Missed& missed, const Examined& examined, FaultCheck& check) {
  check.definitions += SignedDistancesText(examined.query);
  const bool is_rim = missed.legal_of_three > kLegalUnspanned;
  check.definitions += fmt::format(
      R"(
// The share of the patch that contacts may leave unspanned: a sixteenth of its extent{}
// and a rounding.
double LegallyUnspanned({}) {{
  return {} + {};
}}
)",
      is_rim ? ",\n// or what a triangle of contacts inscribed in its rim leaves," : "",
      is_rim ? "const Answer& answer" : "const Answer&",
      is_rim ? fmt::format("(answer.contacts.size() < 3 ? {} : {})",
                           Literal(kLegalUnspanned), Literal(missed.legal_of_three))
             : Literal(kLegalUnspanned),
      Literal(missed.blur));
  const Eigen::Vector3d& n_W = examined.n_W;
  check.statements += fmt::format(
      R"(  // The bodies reach as deep at the point p as anywhere along the normal n: with their
  // separation s along n, p - n s/2 lies on the surface of A and p + n s/2 on that of B.
  const Vector p = {{{}}};
  const Vector n = {{{}}};
  const double s = {};
  const Vector a = Along(p, -s / 2, n);
  const Vector b = Along(p, s / 2, n);
  std::printf("the point (%.17g, %.17g, %.17g) between (%.17g, %.17g, %.17g), %.17g from the "
              "surface of A, and (%.17g, %.17g, %.17g), %.17g from that of B\n", p[0], p[1],
              p[2], a[0], a[1], a[2], FromA(a), b[0], b[1], b[2], FromB(b));
  // Across n, d.(p - c) is the share of the patch's extent by which a contact at c falls
  // short of p. No point between the contacts comes nearer to p than the nearest of them.
  const Vector d = {{{}}};
  double unspanned = 1;
  for (const Contact& c : answer.contacts) {{
    const double share = Dot(d, Along(p, -1, c.p));
    std::printf("a contact falls short of it by %.17g of the patch's extent\n", share);
    if (std::isnan(share) || share < unspanned) unspanned = share;
  }}
)",
      Literals(missed.p_W), Literals(n_W), Literal(examined.separation),
      Literals(missed.shortfall_W));
}

}  // namespace

FaultCheck OffPatchCheck(const FaultSubject& subject) {
  const Examined examined(subject);
  const ContactPatch patch = PatchAlong(examined.query, examined.n_W, examined.separation,
                                        examined.tolerances.across / 2);
  const double deepest = subject.truth.separation.hi + examined.tolerances.separation;
  const ContactPoint* worst = nullptr;
  Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
  for (const ContactPoint& contact : subject.answer.points) {
    if (patch.vertices_W.empty() || contact.separation > deepest) continue;
    const Eigen::Vector3d off = OffsetFromPatch(patch, examined.stated_W, contact);
    if (off.norm() <= farthest.norm()) continue;
    farthest = off;
    worst = &contact;
  }
  if (worst == nullptr || !(farthest.norm() > subject.finding.tolerance)) Refuse(subject);
  FaultCheck check = CheckAlong(examined.stated_W);
  check.definitions += SignedDistancesText(examined.query);
  check.statements = fmt::format(
      R"(  // Along the normal the bodies are deepest in the polygon with these corners, drawn a bit
  // wider, since a rounding of the depth moves a deepest point:
{}  // No point x of it has d.(x - q) > 0. Contacts with a separation of at most `deepest` claim
  // to be that deep; shallower ones may lie elsewhere.
  const Vector d = {{{}}};
  const Vector q = {{{}}};
  const double deepest = {};
  double error = 0;
  for (const Contact& c : answer.contacts) {{
    if (c.s > deepest) continue;
    const double off = Dot(d, Along(c.p, -1, q));
    const Vector n = Unit(c.n);
    std::printf("a contact is %.17g from the patch along (%.17g, %.17g, %.17g); its points "
                "are %.17g from the surface of A and %.17g from that of B\n", off, d[0], d[1],
                d[2], FromA(Along(c.p, -c.s / 2, n)), FromB(Along(c.p, c.s / 2, n)));
    if (std::isnan(off) || off > error) error = off;
  }}
)",
      CornersText(patch), Literals(Eigen::Vector3d(farthest.normalized())),
      Literals(Eigen::Vector3d(worst->p_WC - farthest)), Literal(deepest));
  return check;
}

FaultCheck CoverageCheck(const FaultSubject& subject) {
  const Examined examined(subject);
  const std::optional<Missed> missed = FindMissed(subject, examined);
  if (!missed) Refuse(subject);
  FaultCheck check = CheckAlong(examined.stated_W);
  WriteUnspanned(*missed, examined, check);
  check.statements += "  const double error = std::max(0.0, unspanned);\n";
  check.allowed = "LegallyUnspanned(answer)";
  return check;
}

FaultCheck CountCheck(const FaultSubject& subject) {
  const Examined examined(subject);
  const double same = examined.tolerances.position;
  const std::vector<ContactPoint>& contacts = subject.answer.points;
  const int repeated = ContactCountError(0, contacts, same);
  std::optional<Missed> missed;
  if (subject.finding.value > repeated) missed = FindMissed(subject, examined);
  if (!missed && repeated == 0) Refuse(subject);

  FaultCheck check;
  if (missed) {
    check = CheckAlong(examined.stated_W);
    WriteUnspanned(*missed, examined, check);
  } else {
    check.applies = SaysTouching(true);
    check.applies_to = "touching";
  }
  check.statements += fmt::format(
      R"(  // Contacts nearer than this to an earlier one are repeated: they push twice where the
  // bodies touch once.
  const double same = {};
  int repeated = 0;
  for (std::size_t i = 0; i < answer.contacts.size(); ++i) {{
    bool is_repeated = false;
    for (std::size_t k = 0; k < i; ++k) {{
      const Vector& u = answer.contacts[k].p;
      const Vector& v = answer.contacts[i].p;
      if (std::hypot(u[0] - v[0], u[1] - v[1], u[2] - v[2]) < same) is_repeated = true;
    }}
    if (is_repeated) ++repeated;
  }}
  std::printf("contacts: %zu, of them repeated: %d\n", answer.contacts.size(), repeated);
)",
      Literal(same));
  check.statements +=
      missed
          ? fmt::format(
                "  // The fewest contacts that span the patch, unless they do span it.\n"
                "  const int needed = unspanned > LegallyUnspanned(answer) ? {} : 0;\n"
                "  std::printf(\"the patch needs %d contacts: they leave out %.17g of "
                "it, "
                "and may %.17g\\n\", needed, unspanned, LegallyUnspanned(answer));\n"
                "  const int missing = needed - "
                "(static_cast<int>(answer.contacts.size()) "
                "- repeated);\n"
                "  const double error = std::max({{missing, repeated, 0}});\n",
                missed->least_contacts)
          : "  const double error = repeated;\n";
  return check;
}

}  // namespace touchstone
