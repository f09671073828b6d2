#include "reports/reproduce/contact_check.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "reports/contacts/checks/witness_error.h"
#include "reports/contacts/normal_claim.h"
#include "reports/contacts/tolerances.h"
#include "reports/measures/stated.h"
#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/surface_text.h"

namespace touchstone {
namespace {

/** Calls `check(a, b, n)` for the two points of every contact and, if the recorded answer
 has them, for the witness points. */
std::string ForAllPoints(const ContactAnswer& answer) {
  std::string text =
      "  for (const Contact& c : answer.contacts) {\n"
      "    const Vector n = Unit(c.n);\n"
      "    check(Along(c.p, -c.s / 2, n), Along(c.p, c.s / 2, n), n);\n"
      "  }\n";
  if (answer.witnesses)
    text += "  if (answer.a != answer.b) check(answer.a, answer.b, Unit(answer.n));\n";
  return text;
}

constexpr const char* kSurfaces =
    R"(  // The points of a contact, p - n s/2 and p + n s/2, should lie on the surfaces of A and B.
  double error = 0;
  const auto check = [&](const Vector& a, const Vector& b, const Vector&) {
    const double off_A = FromA(a);
    const double off_B = FromB(b);
    std::printf("its point on A (%.17g, %.17g, %.17g): %.17g from the surface of A\n",
                a[0], a[1], a[2], off_A);
    std::printf("its point on B (%.17g, %.17g, %.17g): %.17g from the surface of B\n",
                b[0], b[1], b[2], off_B);
    for (const double off : {std::abs(off_A), std::abs(off_B)})
      if (std::isnan(off) || off > error) error = off;
  };
)";

constexpr const char* kBeyond = R"(
// How far a body extends from p along the unit vector n: up to the last point of that line
// within kRounding of the body. Convexity leaves one such stretch, which is halved down.
// Less than kLeast counts as 0: a surface that faces along n stays behind the line at once.
constexpr double kRounding = {};
constexpr double kLeast = {};
constexpr double kFarthest = {};
template <typename Distance>
double Beyond(Distance distance, const Vector& p, const Vector& n) {{
  const auto is_within = [&](double t) {{
    return distance(Along(p, t, n)) <= kRounding;
  }};
  if (!is_within(kLeast)) return 0;
  double inside = kLeast, outside = kFarthest;
  for (int i = 0; i < 40; ++i) {{
    const double middle = inside + (outside - inside) / 2;
    (is_within(middle) ? inside : outside) = middle;
  }}
  return inside;
}}
)";

constexpr const char* kTooShallow =
    R"(  // Along n, A should end at the point on A, and against n B at the point on B. If one of
  // them extends further, the bodies overlap there by that much more than the contact says.
  double error = 0;
  const auto check = [&](const Vector& a, const Vector& b, const Vector& n) {
    const double more_A = Beyond(FromA, a, n);
    const double more_B = Beyond(FromB, b, {-n[0], -n[1], -n[2]});
    const Vector end_A = Along(a, more_A, n);
    const Vector end_B = Along(b, -more_B, n);
    std::printf("A extends by %.17g beyond its point on A (%.17g, %.17g, %.17g), to "
                "(%.17g, %.17g, %.17g)\n", more_A, a[0], a[1], a[2], end_A[0], end_A[1],
                end_A[2]);
    std::printf("B extends by %.17g beyond its point on B (%.17g, %.17g, %.17g), to "
                "(%.17g, %.17g, %.17g)\n", more_B, b[0], b[1], b[2], end_B[0], end_B[1],
                end_B[2]);
    error = std::max({error, more_A, more_B});
  };
)";

constexpr const char* kSurplus =
    R"(  // Bodies that touch have no contact where they are apart.
  double error = 0;
  for (const Contact& c : answer.contacts) error = std::max(error, c.s);
)";

/** Returns the largest separation of a contact. [m] */
double WidestGap(const ContactAnswer& answer) {
  double gap = 0;
  for (const ContactPoint& contact : answer.points)
    gap = std::max(gap, contact.separation);
  return gap;
}

}  // namespace

FaultCheck OfAnswersLike(const ContactAnswer& answer, std::string definitions,
                         std::string statements) {
  return {.definitions = std::move(definitions),
          .statements = std::move(statements),
          .applies = SaysTouching(answer.touching),
          .applies_to = answer.touching ? "touching" : "apart"};
}

FaultCheck OfNearestPoints(FaultCheck check) {
  check.applies += " && answer.a != answer.b";
  check.applies_to += ", with nearest points";
  return check;
}

std::string SaysTouching(bool touching) {
  return touching ? "answer.touching" : "!answer.touching";
}

std::string VectorText() {
  return R"(
// The point p + t d.
[[maybe_unused]] Vector Along(const Vector& p, double t, const Vector& d) {
  return {p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
}
[[maybe_unused]] double Dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[maybe_unused]] Vector Unit(const Vector& v) {
  const double length = std::sqrt(Dot(v, v));
  return length > 0 ? Vector{v[0] / length, v[1] / length, v[2] / length} : v;
}
)";
}

FaultCheck SurfaceErrorCheck(const FaultSubject& subject) {
  FaultCheck check = OfAnswersLike(subject.answer);
  check.definitions = VectorText() + SignedDistancesText(subject.scenario.contact);
  check.statements = kSurfaces + ForAllPoints(subject.answer);
  return check;
}

FaultCheck ContactSeparationCheck(const FaultSubject& subject) {
  FaultCheck check = OfAnswersLike(subject.answer);
  // The measure is the widest gap if no body extends beyond a contact.
  if (subject.finding.value == WidestGap(subject.answer)) {
    check.statements = kSurplus;
    return check;
  }
  const ContactQuery& query = subject.scenario.contact;
  const Tolerances tolerances = TolerancesOf(subject.oracle, subject.scenario,
                                             subject.truth, subject.answer.touching);
  const double least = tolerances.across;
  const double farthest = std::max(4 * SceneSize(query), 2 * least);
  check.definitions = VectorText() + SignedDistancesText(query) +
                      fmt::format(kBeyond, Literal(tolerances.position), Literal(least),
                                  Literal(farthest));
  // Witness points are judged along the normal of the answer.
  ContactAnswer judged = subject.answer;
  if (!judged.touching || !judged.n_AB_W) judged.witnesses.reset();
  check.statements = kTooShallow + ForAllPoints(judged);
  return check;
}

FaultCheck TooDeepCheck(const FaultSubject& subject) {
  FaultCheck check = OfAnswersLike(subject.answer);
  check.statements = fmt::format(
      "  // No point lies deeper in both bodies than the shortest translation that\n"
      "  // separates them is long. The true separation is certified to be at least "
      "this.\n"
      "  const double lo = {};\n"
      "  std::printf(\"truth: separation at least %.17g (negative: overlap)\\n\", lo);\n"
      "  double error = 0;\n"
      "  for (const Contact& c : answer.contacts) error = std::max(error, lo - c.s);\n",
      Literal(subject.truth.separation.lo));
  return check;
}

FaultCheck MixedNormalsCheck(const FaultSubject& subject) {
  FaultCheck check = OfAnswersLike(subject.answer);
  check.definitions = VectorText();
  check.statements =
      "  // The largest angle between the normals of two contacts, in radians.\n"
      "  double error = 0;\n"
      "  for (const Contact& c : answer.contacts) {\n"
      "    for (const Contact& d : answer.contacts) {\n"
      "      const Vector& m = c.n;\n"
      "      const Vector& n = d.n;\n"
      "      const Vector cross = {m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * "
      "n[2],\n"
      "                            m[0] * n[1] - m[1] * n[0]};\n"
      "      error = std::max(error, std::atan2(std::sqrt(Dot(cross, cross)), Dot(m, "
      "n)));\n"
      "    }\n  }\n";
  return check;
}

FaultCheck WitnessErrorCheck(const FaultSubject& subject) {
  FaultCheck check = OfNearestPoints(OfAnswersLike(subject.answer));
  check.definitions = VectorText();
  check.statements =
      "  const Vector ab = {answer.b[0] - answer.a[0], answer.b[1] - answer.a[1],\n"
      "                     answer.b[2] - answer.a[2]};\n";
  const std::optional<Eigen::Vector3d> n = NormalOf(subject.answer);
  const Capability& capability = subject.oracle.For(
      KindOf(subject.scenario.contact.A.shape), KindOf(subject.scenario.contact.B.shape));
  if (!n || !ClaimsLeastDirection(subject.truth, capability, subject.answer)) {
    check.statements +=
        "  // The nearest points should be as far apart as the separation says.\n"
        "  const double length = std::sqrt(Dot(ab, ab));\n"
        "  std::printf(\"distance of its points: %.17g\\n\", length);\n"
        "  const double error = std::abs(length - std::abs(answer.separation));\n";
    return check;
  }
  const WitnessError off =
      WitnessErrorOf(*subject.answer.witnesses, *n, *SeparationOf(subject.answer));
  check.statements += fmt::format(
      "  // The nearest points should differ by the separation times the normal.\n"
      "  const Vector n = Unit(answer.n);\n  const double along = Dot(ab, n);\n"
      "  const Vector across = Along(ab, -along, n);\n"
      "  const double off_along = std::abs(along - answer.separation);\n"
      "  const double off_across = std::sqrt(Dot(across, across));\n"
      "  std::printf(\"distance of its points along the normal: %.17g, off by %.17g, and "
      "by %.17g across it\\n\", along, off_along, off_across);\n"
      "  const double error = {};\n",
      subject.finding.value == off.across ? "off_across" : "off_along");
  return check;
}

}  // namespace touchstone
