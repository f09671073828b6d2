#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "reports/contacts/checks/contact_surface_error.h"
#include "reports/contacts/judge_answer.h"
#include "reports/referee/referee.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/specimens.h"

// Each test takes a right answer, changes one field of it, and requires that the judge
// finds a fault.
namespace touchstone {
namespace {

using Change = std::function<void(const ContactQuery&, ContactAnswer&)>;

constexpr double kDepth = 2e-3;  // [m]

/** Returns a random length in [least, most], to three digits. [m] */
double RandomLength(double least, double most) {
  return least + (most - least) * *rc::gen::inRange(0, 1000) / 999;
}

//      ________
//     |   B    |    B stands on A and is `depth` deep in it. Their sides at x = a are
//   __|________|    flush if drawn so, and B is yawed otherwise.
//  |    A      |
//  |___________|
//
/** Returns a random pair of boxes, face on face. */
ContactQuery BoxOnBox(double depth) {
  const Eigen::Vector3d a(RandomLength(0.3, 1), RandomLength(0.3, 1),
                          RandomLength(0.1, 1));
  const Eigen::Vector3d b(RandomLength(0.05, 0.2), RandomLength(0.05, 0.2),
                          RandomLength(0.05, 1));
  const bool flush = *rc::gen::arbitrary<bool>();
  const double yaw = flush ? 0 : RandomLength(0.1, 0.6);
  const double x = flush ? a.x() - b.x() : RandomLength(-0.01, 0.01);
  const Pose X_WA = *rc::gen::arbitrary<bool>() ? AwkwardPose() : Pose{};
  const Eigen::Matrix3d R(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  return {{Box{a}, X_WA}, {Box{b}, Placed(X_WA, {x, 0.01, a.z() + b.z() - depth}, R)}};
}

/** Returns the right answer: contacts at the lower corners of B, all of which are above
 A, with witness points, also of penetrating bodies. */
ContactAnswer Right(const ContactQuery& query, double depth) {
  ContactAnswer answer = RightAnswer(query);
  if (depth < 0) return answer;
  answer.points.clear();
  const Eigen::Vector3d& half = std::get<Box>(query.B.shape).half_extents;
  for (const auto& [x, y] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}}) {
    const Eigen::Vector3d corner_B(x * half.x(), y * half.y(), depth / 2 - half.z());
    answer.points.push_back({query.B.X_WB * corner_B, -depth, {}});
  }
  answer.witnesses = SurfacePointsOf(answer.points.front(), *answer.n_AB_W);
  return answer;
}

std::vector<Finding> Judged(const ContactQuery& query, const ContactAnswer& answer) {
  FakeOracle oracle("mine");
  oracle.ForEachPair(
      [](Capability& capability) { capability.penetrating_witnesses = true; });
  Scenario scenario;
  scenario.id = "contact/perturbed";
  scenario.contact = query;
  return JudgeAnswer(scenario, ComputeContactTruth(query), oracle.info(), answer);
}

std::string Verdicts(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings) {
    text += std::string(NameOf(f.measure)) + " " + std::string(NameOf(f.verdict)) + " " +
            f.proof + "; ";
  }
  return text;
}

void Check(double depth, const Change& change) {
  const ContactQuery query = BoxOnBox(depth);
  ContactAnswer answer = Right(query, depth);
  const std::vector<Finding> right = Judged(query, answer);
  RC_LOG() << Verdicts(right);
  RC_ASSERT(std::all_of(right.begin(), right.end(),
                        [](const Finding& f) { return f.verdict == Verdict::kPass; }));
  change(query, answer);
  const std::vector<Finding> wrong = Judged(query, answer);
  RC_LOG() << Verdicts(wrong);
  RC_ASSERT(std::any_of(wrong.begin(), wrong.end(),
                        [](const Finding& f) { return IsFailure(f.verdict); }));
}

ContactPoint& Any(ContactAnswer& answer) {
  return answer.points[*rc::gen::inRange<std::size_t>(0, answer.points.size())];
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereAContactHasAnotherDepth, ()) {
  Check(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    Any(answer).separation += *rc::gen::element(-1e-3, 1e-4, 1e-3, 3e-3);
  });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereAContactLiesOnAnotherSide, ()) {
  Check(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    Any(answer).p_WC += *rc::gen::element(-0.02, -1e-3, 1e-3, 0.02) * *answer.n_AB_W;
  });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereTheNormalIsFlipped, ()) {
  Check(*rc::gen::element(kDepth, -kDepth),
        [](const ContactQuery&, ContactAnswer& answer) { *answer.n_AB_W *= -1; });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereTheNormalOfOneContactIsFlipped, ()) {
  Check(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    Any(answer).n_AB_W = -*answer.n_AB_W;
  });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereWitnessesAreExchanged, ()) {
  Check(*rc::gen::element(kDepth, -kDepth),
        [](const ContactQuery&, ContactAnswer& answer) {
          std::swap(answer.witnesses->p_WCa, answer.witnesses->p_WCb);
        });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereWitnessesLieFarApart, ()) {
  Check(kDepth, [](const ContactQuery& query, ContactAnswer& answer) {
    // To the bottom of A: still a point of its surface.
    const double height = 2 * std::get<Box>(query.A.shape).half_extents.z();
    answer.witnesses->p_WCa -= height * *answer.n_AB_W;
  });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWithoutPromisedWitnesses, ()) {
  Check(*rc::gen::element(kDepth, -kDepth),
        [](const ContactQuery&, ContactAnswer& answer) { answer.witnesses.reset(); });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereAContactIsDropped, ()) {
  Check(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    answer.points.erase(answer.points.begin() +
                        *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(answer.points)));
  });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereContactsAreDrawnTowardsTheMiddle, ()) {
  Check(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const ContactPoint& c : answer.points)
      middle += c.p_WC / static_cast<double>(answer.points.size());
    const double share = *rc::gen::element(0.5, 0.8);
    for (ContactPoint& c : answer.points) c.p_WC = middle + share * (c.p_WC - middle);
  });
}

RC_GTEST_PROP(PerturbedAnswer, FailsWhereAContactIsAddedThatIsApart, ()) {
  Check(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    ContactPoint added = Any(answer);
    added.separation = *rc::gen::element(1e-3, 1.9);
    answer.points.push_back(added);
  });
}

/** Changes a right answer into another one that is as right. */
void PassesAfter(double depth, const Change& change) {
  const ContactQuery query = BoxOnBox(depth);
  ContactAnswer answer = Right(query, depth);
  change(query, answer);
  const std::vector<Finding> findings = Judged(query, answer);
  RC_LOG() << Verdicts(findings);
  RC_ASSERT(std::all_of(findings.begin(), findings.end(),
                        [](const Finding& f) { return f.verdict == Verdict::kPass; }));
}

RC_GTEST_PROP(LegalAnswer, PassesWithContactsInAnyOrderAndMoreBetween, ()) {
  PassesAfter(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    std::rotate(answer.points.begin(),
                answer.points.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, 4),
                answer.points.end());
    ContactPoint between = answer.points[0];
    const double share = RandomLength(0.1, 0.9);
    between.p_WC += share * (answer.points[*rc::gen::element<std::size_t>(1, 2, 3)].p_WC -
                             between.p_WC);
    answer.points.push_back(between);
  });
}

RC_GTEST_PROP(LegalAnswer, PassesWithTheFieldsInItsContactsOnly, ()) {
  PassesAfter(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    for (ContactPoint& contact : answer.points) contact.n_AB_W = answer.n_AB_W;
    answer.n_AB_W.reset();
    answer.separation.reset();
  });
}

RC_GTEST_PROP(LegalAnswer, PassesWithWitnessesAnywhereInThePatch, ()) {
  PassesAfter(kDepth, [](const ContactQuery&, ContactAnswer& answer) {
    const Eigen::Vector3d along = answer.points[2].p_WC - answer.points[0].p_WC;
    const Eigen::Vector3d moved = RandomLength(0.01, 0.99) * along;
    answer.witnesses->p_WCa += moved;
    answer.witnesses->p_WCb += moved;
  });
}

// A contact on the rim of A where a tilted B leaves it: as deep as the bodies are there.
RC_GTEST_PROP(LegalAnswer, PassesWithShallowerContactsOfATiltedBox, ()) {
  const double tilt = RandomLength(0.01, 0.3);
  const Eigen::Matrix3d R(Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()));
  const Eigen::Vector3d b(0.1, 0.07, 0.2);
  const Eigen::Vector3d low = R * Eigen::Vector3d(b.x(), b.y(), -b.z());
  const Eigen::Vector3d p_A(0.02, 0.01, 0.1 - low.z() - 0.05);
  const Pose X_WA = AwkwardPose();
  const ContactQuery query{{Box{{0.3, 0.2, 0.1}}, X_WA}, {Box{b}, Placed(X_WA, p_A, R)}};
  const ContactTruth truth = ComputeContactTruth(query);
  const Eigen::Vector3d n_W = X_WA.R_WB.col(2);
  RC_PRE(truth.certificate.n_AB_W.dot(n_W) > 1 - 1e-9);
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = true;
  answer.n_AB_W = n_W;
  answer.separation = -0.05;
  for (const double x : {b.x(), -b.x()}) {
    for (const double y : {b.y(), -b.y()}) {
      const Eigen::Vector3d corner_A = p_A + R * Eigen::Vector3d(x, y, -b.z());
      const double s = corner_A.z() - 0.1;
      if (s > 0) continue;
      answer.points.push_back(
          {X_WA * Eigen::Vector3d(corner_A.x(), corner_A.y(), 0.1 + s / 2), s, {}});
    }
  }
  answer.witnesses = SurfacePointsOf(answer.points.front(), n_W);
  const std::vector<Finding> findings = Judged(query, answer);
  RC_LOG() << Verdicts(findings);
  RC_ASSERT(std::all_of(findings.begin(), findings.end(),
                        [](const Finding& f) { return f.verdict == Verdict::kPass; }));
}

// Any direction is a separating one or not; without a distance nothing else is claimed.
TEST(PerturbedAnswer, IsNotRightWhereANormalAloneSeparatesNothing) {
  const Specimen s = BoxOnBoxFace(-kDepth);
  FakeOracle modest("mine");
  modest.ForEachPair([](Capability& capability) {
    capability.distance = false;
    capability.witnesses = false;
  });
  const auto excess_of = [&](const Eigen::Vector3d& n_AB_W) {
    Scenario scenario;
    scenario.contact = s.query;
    ContactAnswer answer = s.right;
    answer.separation.reset();
    answer.witnesses.reset();
    answer.n_AB_W = n_AB_W;
    for (const Finding& f : JudgeAnswer(scenario, s.truth, modest.info(), answer)) {
      if (f.measure == MeasureKind::kExcess) return f;
    }
    ADD_FAILURE() << "the normal is not judged";
    return Finding{};
  };
  EXPECT_EQ(excess_of(*s.right.n_AB_W).verdict, Verdict::kPass);
  const Finding across = excess_of(s.right.n_AB_W->unitOrthogonal());
  EXPECT_EQ(across.verdict, Verdict::kUndecidable);
  EXPECT_EQ(across.undecided, Undecided::kUnverified);
  const Finding flipped = excess_of(-*s.right.n_AB_W);
  EXPECT_EQ(flipped.verdict, Verdict::kFail);
  EXPECT_NE(flipped.proof.find("points from B to A"), std::string::npos);
}

}  // namespace
}  // namespace touchstone
