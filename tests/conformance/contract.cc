#include "tests/conformance/contract.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <sstream>
#include <thread>
#include <utility>

#include <Eigen/Core>

#include "reports/contacts/tolerances.h"
#include "tests/oracles/constructed_contact.h"
#include "tests/oracles/surface.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

constexpr double kGap = 2e-3;  // [m] A hundredth of the smallest feature.

// [m] The radius of the capsule, the smallest of the constructed shapes.
constexpr double kSmallestRadius = 0.23;

std::string Printed(const Vector3d& v) {
  std::ostringstream out;
  out.precision(17);
  out << '[' << v.x() << ", " << v.y() << ", " << v.z() << ']';
  return out.str();
}

std::string Printed(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

ConstructedContact Moved(const ConstructedContact& contact, const Pose& X) {
  const auto move = [&](const Body& body) {
    return Body{body.shape,
                Pose::FromMatrix(X * body.X_WB.p_WB, X.R_WB * body.X_WB.R_WB)};
  };
  return {{move(contact.query.A), move(contact.query.B)},
          X.R_WB * contact.n_AB_W,
          contact.separation,
          X * contact.p_WM};
}

/* Sixteen random poses for the pair. A fault that depends on the rounding of a direction
 shows in some of them. */
std::vector<Pose> Placements() {
  std::mt19937_64 random(20260611);
  std::vector<Pose> placements(16);
  for (Pose& X : placements) X = RandomPose(1, random);
  return placements;
}

const Capability& CapabilityOf(const Oracle& oracle, const ContactQuery& query) {
  return oracle.info().For(KindOf(query.A.shape), KindOf(query.B.shape));
}

/* The tolerance of every length along the normal. [m] */
double LengthError(const Oracle& oracle, const ContactQuery& query) {
  const Capability& capability = CapabilityOf(oracle, query);
  return kRoundings * oracle.info().unit_roundoff * SceneSize(query) +
         capability.documented_error + capability.documented_relative_error * kGap;
}

/* The largest angle by which a length error e can tilt the normal. Apart, the normal
 joins two points kGap from each other, each off by e. Penetrating, the overlap along a
 normal that is off by t exceeds the true depth by 1 - cos t times the radius of a round
 feature, or by t times the width of a flat one. The round feature allows the larger tilt
 for small t: t <= sqrt(2 e / r). [rad] */
double AngleError(double e, double separation) {
  return separation > 0 ? 2 * e / separation : std::sqrt(2 * e / kSmallestRadius);
}

/* Asks all queries in one batch, which an isolated oracle answers in one child. */
std::vector<ContactAnswer> Ask(const Oracle& oracle,
                               const std::vector<ContactQuery>& queries) {
  std::vector<ContactAnswer> answers(queries.size());
  oracle.Answer(queries, answers);
  return answers;
}

/** Collects breaches about one question. */
class Report {
 public:
  Report(Breaches& breaches, const ContactQuery& query, std::string about)
      : breaches_(breaches),
        prefix_(std::string(NameOf(KindOf(query.A.shape))) + " - " +
                std::string(NameOf(KindOf(query.B.shape))) + ", " + std::move(about) +
                ": ") {}

  // The caller must write `held` so that a NaN makes it false.
  bool Expect(bool held, const std::string& otherwise) {
    if (!held) breaches_.push_back(prefix_ + otherwise);
    return held;
  }

  void ExpectNear(double value, double truth, double allowed, const std::string& what) {
    Expect(std::abs(value - truth) <= allowed, what + " " + Printed(value) +
                                                   ", expected " + Printed(truth) +
                                                   " within " + Printed(allowed));
  }

  void ExpectDirection(const Vector3d& n, const Vector3d& truth, double allowed) {
    Expect((n - truth).norm() <= allowed, "normal " + Printed(n) + ", expected " +
                                              Printed(truth) + " within " +
                                              Printed(allowed));
  }

 private:
  Breaches& breaches_;
  std::string prefix_;
};

bool HasAnswered(Report& report, const ContactAnswer& answer) {
  return report.Expect(answer.status == AnswerStatus::kAnswered,
                       "no answer: " + answer.reason);
}

void ExpectPromised(Report& report, const Capability& capability,
                    const ContactAnswer& answer) {
  if (answer.touching) {
    report.Expect(!capability.depth || answer.separation, "promised depth is missing");
    report.Expect(!capability.normal || answer.n_AB_W, "promised normal is missing");
    report.Expect(!capability.manifold || !answer.points.empty(),
                  "promised contacts are missing");
  } else {
    report.Expect(!capability.distance || answer.separation,
                  "promised distance is missing");
    // Only checked for bodies apart: many engines have no witnesses for overlapping ones.
    report.Expect(!capability.witnesses || answer.witnesses,
                  "promised witnesses are missing");
    report.Expect(answer.points.empty(), "contacts of bodies that do not touch");
  }
}

void ExpectTruth(Report& report, const Oracle& oracle, const ConstructedContact& truth,
                 const ContactAnswer& answer) {
  if (!HasAnswered(report, answer)) return;
  ExpectPromised(report, CapabilityOf(oracle, truth.query), answer);
  const double e = LengthError(oracle, truth.query);
  report.Expect(answer.touching == (truth.separation <= 0), "touching is wrong");
  if (answer.separation) {
    report.ExpectNear(*answer.separation, truth.separation, e, "separation");
  }
  if (answer.n_AB_W) {
    const double angle =
        AngleError(e, truth.separation) + kNormalRoundings * oracle.info().unit_roundoff;
    report.ExpectDirection(*answer.n_AB_W, truth.n_AB_W, angle);
  }
  for (const ContactPoint& point : answer.points) {
    const double height = truth.n_AB_W.dot(point.p_WC - truth.p_WM);
    report.Expect(std::abs(height) <= kGap / 2 + e,
                  "contact " + Printed(height) + " m off the middle of the overlap");
    report.Expect(point.separation >= truth.separation - e,
                  "contact deeper than the bodies: " + Printed(point.separation));
  }
  if (answer.witnesses) {
    report.ExpectNear(HeightAboveSurface(truth.query.A, answer.witnesses->p_WCa), 0, e,
                      "height of A's witness above A");
    report.ExpectNear(HeightAboveSurface(truth.query.B, answer.witnesses->p_WCb), 0, e,
                      "height of B's witness above B");
  }
}

void ExpectSame(Report& report, double e, const ContactAnswer& answer,
                const ContactAnswer& other, const Eigen::Matrix3d& turn) {
  if (!HasAnswered(report, answer) || !HasAnswered(report, other)) return;
  report.Expect(answer.touching == other.touching, "touching changes");
  report.Expect(answer.separation.has_value() == other.separation.has_value() &&
                    answer.n_AB_W.has_value() == other.n_AB_W.has_value() &&
                    answer.points.empty() == other.points.empty() &&
                    answer.witnesses.has_value() == other.witnesses.has_value(),
                "a field appears or disappears");
  // Each of the two answers may be off by e.
  if (answer.separation && other.separation) {
    report.ExpectNear(*other.separation, *answer.separation, 2 * e, "separation");
  }
  if (answer.n_AB_W && other.n_AB_W) {
    report.ExpectDirection(*other.n_AB_W, turn * *answer.n_AB_W,
                           2 * AngleError(e, answer.touching ? -kGap : kGap));
  }
}

bool SameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool SameBits(const Vector3d& a, const Vector3d& b) {
  return SameBits(a.x(), b.x()) && SameBits(a.y(), b.y()) && SameBits(a.z(), b.z());
}

bool SameBits(const ContactPoint& a, const ContactPoint& b);
bool SameBits(const WitnessPoints& a, const WitnessPoints& b);

template <typename T>
bool SameBits(const std::optional<T>& a, const std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || SameBits(*a, *b));
}

bool SameBits(const ContactPoint& a, const ContactPoint& b) {
  return SameBits(a.p_WC, b.p_WC) && SameBits(a.separation, b.separation) &&
         SameBits(a.n_AB_W, b.n_AB_W);
}

bool SameBits(const WitnessPoints& a, const WitnessPoints& b) {
  return SameBits(a.p_WCa, b.p_WCa) && SameBits(a.p_WCb, b.p_WCb);
}

bool SameBits(const ContactAnswer& a, const ContactAnswer& b) {
  return a.status == b.status && a.reason == b.reason && a.touching == b.touching &&
         SameBits(a.n_AB_W, b.n_AB_W) && SameBits(a.separation, b.separation) &&
         SameBits(a.witnesses, b.witnesses) &&
         std::equal(
             a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
             [](const ContactPoint& p, const ContactPoint& q) { return SameBits(p, q); });
}

std::vector<ContactQuery> SupportedQuestions(const Oracle& oracle) {
  std::vector<ContactQuery> queries;
  for (const auto& [a, b] : AllPairs()) {
    if (!oracle.info().For(a, b).supported) continue;
    queries.push_back(PutTogether(a, b, -kGap).query);
    queries.push_back(PutTogether(a, b, kGap).query);
  }
  return queries;
}

std::vector<ContactAnswer> AnswersInReverse(const Oracle& oracle,
                                            const std::vector<ContactQuery>& queries) {
  std::vector<ContactAnswer> answers(queries.size());
  for (std::size_t i = queries.size(); i-- > 0;) answers[i] = oracle.Answer(queries[i]);
  return answers;
}

}  // namespace

Breaches KnownAnswer(const Oracle& oracle, ShapeKind a, ShapeKind b) {
  std::vector<ConstructedContact> truths;
  std::vector<ContactQuery> queries;
  for (const Pose& X : Placements()) {
    for (const double separation : {-kGap, kGap}) {
      for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)}) {
        truths.push_back(Moved(PutTogether(first, second, separation), X));
        queries.push_back(truths.back().query);
      }
    }
  }
  const std::vector<ContactAnswer> answers = Ask(oracle, queries);
  Breaches breaches;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    Report report(breaches, queries[i],
                  truths[i].separation < 0 ? "2 mm deep" : "2 mm apart");
    ExpectTruth(report, oracle, truths[i], answers[i]);
  }
  return breaches;
}

Breaches Swap(const Oracle& oracle, ShapeKind a, ShapeKind b) {
  std::vector<ContactQuery> queries;
  std::vector<ContactQuery> swapped;
  for (const Pose& X : Placements()) {
    for (const double separation : {-kGap, kGap}) {
      queries.push_back(Moved(PutTogether(a, b, separation), X).query);
      swapped.push_back({queries.back().B, queries.back().A});
    }
  }
  const std::vector<ContactAnswer> answers = Ask(oracle, queries);
  const std::vector<ContactAnswer> after = Ask(oracle, swapped);
  Breaches breaches;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    Report report(breaches, queries[i], "swapped");
    ExpectSame(report, LengthError(oracle, queries[i]), answers[i], after[i],
               -Eigen::Matrix3d::Identity());
  }
  return breaches;
}

Breaches PushApart(const Oracle& oracle, ShapeKind a, ShapeKind b) {
  Breaches breaches;
  const Capability& capability = oracle.info().For(a, b);
  if (!capability.depth || !capability.normal) return breaches;
  std::vector<ContactQuery> queries;
  for (const Pose& X : Placements()) {
    queries.push_back(Moved(PutTogether(a, b, -kGap), X).query);
  }
  const std::vector<ContactAnswer> answers = Ask(oracle, queries);
  std::vector<ContactQuery> beyond;
  std::vector<ContactQuery> short_of_it;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    Report report(breaches, queries[i], "pushed apart");
    const ContactAnswer& answer = answers[i];
    if (!HasAnswered(report, answer)) continue;
    if (!report.Expect(answer.touching && answer.separation && answer.n_AB_W,
                       "no contact to push apart")) {
      continue;
    }
    // One e for the error of the depth, one e for the error of the next answer. The third
    // covers a normal tilted by t, which moves B too little by 1 - cos t times the depth.
    const double clearance = 3 * LengthError(oracle, queries[i]);
    for (auto& [moved, by] : {std::pair(&beyond, clearance - *answer.separation),
                              std::pair(&short_of_it, -clearance - *answer.separation)}) {
      moved->push_back(queries[i]);
      moved->back().B.X_WB.p_WB += by * *answer.n_AB_W;
    }
  }
  for (const auto& [pushed, touches] :
       {std::pair(&beyond, false), std::pair(&short_of_it, true)}) {
    for (const ContactAnswer& answer : Ask(oracle, *pushed)) {
      Report report(breaches, queries.front(), "pushed apart");
      report.Expect(answer.touching == touches,
                    touches ? "no longer touches after a move of depth - clearance"
                            : "still touches after a move of depth + clearance");
    }
  }
  return breaches;
}

Breaches RigidMotion(const Oracle& oracle, ShapeKind a, ShapeKind b) {
  Breaches breaches;
  const std::vector<Pose> placements = Placements();
  for (const double separation : {-kGap, kGap}) {
    const ConstructedContact contact = PutTogether(a, b, separation);
    std::vector<ContactQuery> queries = {contact.query};
    for (const Pose& X : placements) queries.push_back(Moved(contact, X).query);
    const std::vector<ContactAnswer> answers = Ask(oracle, queries);
    for (std::size_t i = 0; i < placements.size(); ++i) {
      Report report(breaches, queries[i + 1], "moved rigidly");
      const double e = std::max(LengthError(oracle, queries.front()),
                                LengthError(oracle, queries[i + 1]));
      ExpectSame(report, e, answers.front(), answers[i + 1], placements[i].R_WB);
    }
  }
  return breaches;
}

Breaches Pure(const Oracle& oracle) {
  const std::vector<ContactQuery> queries = SupportedQuestions(oracle);
  std::vector<ContactAnswer> once(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) once[i] = oracle.Answer(queries[i]);

  std::vector<ContactAnswer> by_one_thread;
  std::vector<ContactAnswer> by_another;
  std::thread one([&] { by_one_thread = Ask(oracle, queries); });
  std::thread another([&] { by_another = AnswersInReverse(oracle, queries); });
  one.join();
  another.join();

  const std::pair<const char*, std::vector<ContactAnswer>> others[] = {
      {"asked again, in reverse", AnswersInReverse(oracle, queries)},
      {"asked as a batch", Ask(oracle, queries)},
      {"asked by one of two threads", std::move(by_one_thread)},
      {"asked by the other thread", std::move(by_another)},
  };
  Breaches breaches;
  for (const auto& [about, answers] : others) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      Report report(breaches, queries[i], about);
      report.Expect(SameBits(answers[i], once[i]), "a different answer");
    }
  }
  return breaches;
}

}  // namespace touchstone
