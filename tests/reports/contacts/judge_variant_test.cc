#include "reports/contacts/judge_variant.h"

#include <cmath>
#include <functional>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/specimens.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Plant = std::function<void(const ContactQuery&, ContactAnswer&)>;

Scenario ScenarioOf(const ContactQuery& query) {
  Scenario scenario;
  scenario.id = "contact/specimen";
  scenario.contact = query;
  return scenario;
}

/** Judges one variant with the tolerances of the answer to the question. */
std::optional<Finding> JudgedAlone(const Scenario& scenario, const ContactTruth& truth,
                                   const OracleInfo& oracle, const ContactAnswer& answer,
                                   const Variant& variant, const ContactAnswer& other) {
  return JudgeVariant(scenario, truth, oracle, answer, variant, other,
                      TolerancesOf(oracle, scenario, truth, answer.touching));
}

/** Returns the findings of all variants of `query` put to an oracle that is right except
 for `plant`. */
std::vector<Finding> Judged(const ContactQuery& query, const Plant& plant) {
  const FakeOracle oracle = FakeOracle::Wrong("mine", plant);
  const Scenario scenario = ScenarioOf(query);
  const ContactTruth truth = ComputeContactTruth(query);
  std::vector<Finding> findings;
  for (const Variant& variant : VariantsOf(scenario)) {
    const auto finding = JudgedAlone(scenario, truth, oracle.info(), oracle.Answer(query),
                                     variant, oracle.Answer(variant.query));
    if (finding) findings.push_back(*finding);
  }
  return findings;
}

std::vector<MeasureKind> Failed(const std::vector<Finding>& findings) {
  std::vector<MeasureKind> failed;
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.reference, "");
    if (finding.verdict != Verdict::kPass) failed.push_back(finding.measure);
  }
  return failed;
}

const Plant kNothing = [](const ContactQuery&, ContactAnswer&) {};

TEST(Variants, AllPassForARightOracle) {
  for (const double depth : {2e-3, -2e-3}) {
    for (const Specimen& s :
         {SphereInBoxFace(depth), BoxOnBoxFace(depth), SphereInHalfSpace(depth)}) {
      EXPECT_THAT(Failed(Judged(s.query, kNothing)), IsEmpty());
    }
  }
}

TEST(Variants, RelabelOnlyWhereThereIsABox) {
  const auto measures = [](const ContactQuery& query) {
    std::vector<MeasureKind> kinds;
    for (const Variant& v : VariantsOf(ScenarioOf(query))) kinds.push_back(v.measure);
    return kinds;
  };
  EXPECT_THAT(
      measures(SphereInBoxFace(2e-3).query),
      ElementsAre(MeasureKind::kSwap, MeasureKind::kRigidMotion, MeasureKind::kScaling,
                  MeasureKind::kRelabelling, MeasureKind::kPerturbation));
  EXPECT_EQ(measures(SphereInHalfSpace(2e-3).query).size(), 4U);
}

TEST(Variants, DetectANormalThatDoesNotTurnWithTheSwap) {
  // The normal always points out of the box, whichever body that is.
  const Plant out_of_the_box = [](const ContactQuery& query, ContactAnswer& answer) {
    if (KindOf(query.A.shape) == ShapeKind::kSphere) *answer.n_AB_W *= -1;
  };
  const std::vector<Finding> findings =
      Judged(SphereInBoxFace(2e-3).query, out_of_the_box);
  ASSERT_THAT(Failed(findings), ElementsAre(MeasureKind::kSwap));
  EXPECT_EQ(findings[0].cause, Cause::kConvention);
  EXPECT_THAT(findings[0].cause_because, HasSubstr("does not turn"));
}

TEST(Variants, DetectANormalInTheFrameOfABody) {
  const Plant in_frame_A = [](const ContactQuery& query, ContactAnswer& answer) {
    answer.n_AB_W = query.A.X_WB.R_WB.transpose() * *answer.n_AB_W;
  };
  EXPECT_THAT(Failed(Judged(SphereInBoxFace(2e-3).query, in_frame_A)),
              testing::Contains(MeasureKind::kRigidMotion));
}

TEST(Variants, DetectAnAbsoluteMargin) {
  const Plant margin = [](const ContactQuery&, ContactAnswer& answer) {
    *answer.separation -= 1e-3;
  };
  const std::vector<Finding> findings = Judged(SphereInBoxFace(2e-3).query, margin);
  ASSERT_THAT(Failed(findings), ElementsAre(MeasureKind::kScaling));
  // At the scale 1/7.3 the margin is 7.3 times as large in the lengths of the question.
  EXPECT_NEAR(findings[2].value, 6.3e-3, 1e-12);
}

TEST(Variants, DetectAPreferenceForOneAxisOfABox) {
  // The planted oracle recognises the face that the sphere lies on by its label.
  const Plant z_only = [](const ContactQuery& query, ContactAnswer& answer) {
    for (const Body* body : {&query.A, &query.B}) {
      if (KindOf(body->shape) != ShapeKind::kBox) continue;
      if (std::abs(body->X_WB.R_WB.col(2).dot(*answer.n_AB_W)) < 0.9) {
        *answer.separation *= 1.05;
      }
    }
  };
  // 16 of the 24 labellings give the face another axis; the ids select both kinds.
  int found = 0;
  for (int i = 0; i < 12; ++i) {
    Scenario scenario = ScenarioOf(SphereInBoxFace(2e-3).query);
    scenario.id += std::to_string(i);
    const FakeOracle oracle = FakeOracle::Wrong("mine", z_only);
    const Variant relabelled = VariantsOf(scenario)[3];
    const auto finding = JudgedAlone(scenario, ComputeContactTruth(scenario.contact),
                                     oracle.info(), oracle.Answer(scenario.contact),
                                     relabelled, oracle.Answer(relabelled.query));
    found += finding->verdict == Verdict::kFail;
  }
  EXPECT_GT(found, 4);
}

TEST(Variants, DetectAnAnswerThatJumps) {
  // The answer depends on digits far below the size of the scene.
  const Plant jumps = [](const ContactQuery& query, ContactAnswer& answer) {
    *answer.separation *= 1.5 + 0.4 * std::sin(1e9 * query.B.X_WB.p_WB.sum());
  };
  EXPECT_THAT(Failed(Judged(SphereInBoxFace(2e-2).query, jumps)),
              testing::Contains(MeasureKind::kPerturbation));
}

TEST(Variants, AllowAnAnswerToMoveAsFarAsTheBody) {
  // If B moves by a millionth of the scene, the truth changes by a fraction of that.
  const std::vector<Finding> findings = Judged(BoxOnBoxFace(2e-3).query, kNothing);
  EXPECT_EQ(findings[4].measure, MeasureKind::kPerturbation);
  EXPECT_EQ(findings[4].value, 0);
}

TEST(Variants, AllowAnySeparatingDirectionWhereNoDistanceIsPromised) {
  // Many planes separate bodies that are apart: the answer to the swapped question has
  // another one.
  const Specimen s = SphereInBoxFace(-0.05);
  ContactAnswer answer = s.right;
  answer.separation.reset();
  answer.witnesses.reset();
  ContactAnswer other = answer;
  other.n_AB_W = -(*answer.n_AB_W + 0.05 * s.query.A.X_WB.R_WB.col(0)).normalized();
  FakeOracle oracle("mine");
  const Scenario scenario = ScenarioOf(s.query);
  const Variant swapped = VariantsOf(scenario)[0];
  const auto verdict = [&] {
    return JudgedAlone(scenario, s.truth, oracle.info(), answer, swapped, other)->verdict;
  };
  EXPECT_EQ(verdict(), Verdict::kFail);
  oracle.ForEachPair([](Capability& capability) { capability.distance = false; });
  EXPECT_EQ(verdict(), Verdict::kPass);
}

TEST(Variants, DetectAnAnswerInContactsOnlyThatDoesNotTurn) {
  const Plant contacts_of_one_body = [](const ContactQuery& query,
                                        ContactAnswer& answer) {
    if (KindOf(query.A.shape) == ShapeKind::kSphere) *answer.n_AB_W *= -1;
    for (ContactPoint& contact : answer.points) contact.n_AB_W = answer.n_AB_W;
    answer.n_AB_W.reset();
    answer.separation.reset();
  };
  const std::vector<Finding> findings =
      Judged(SphereInBoxFace(2e-3).query, contacts_of_one_body);
  ASSERT_THAT(Failed(findings), ElementsAre(MeasureKind::kSwap));
  EXPECT_EQ(findings[0].cause, Cause::kConvention);
  EXPECT_THAT(findings[0].proof, HasSubstr("mine says n = ("));
  EXPECT_THAT(findings[0].proof, HasSubstr("along which max_A n·x − min_B n·x is 0.00"));
  EXPECT_THAT(findings[0].proof, HasSubstr("variant (swap: A and B exchanged), mapped"));
  EXPECT_THAT(findings[0].proof, HasSubstr("along which that is "));
}

TEST(Variants, AreRefutedByTwoNumbersAndTheirDifference) {
  const Plant deeper_by_a_tenth = [](const ContactQuery& query, ContactAnswer& answer) {
    answer.separation = KindOf(query.A.shape) == ShapeKind::kSphere ? -0.0022 : -0.002;
    answer.points.clear();
  };
  const std::vector<Finding> findings =
      Judged(SphereInBoxFace(2e-3).query, deeper_by_a_tenth);
  ASSERT_FALSE(findings.empty());
  ASSERT_EQ(findings[0].measure, MeasureKind::kSwap);
  EXPECT_EQ(findings[0].proof,
            "mine says 0.002 m deep; for its variant (swap: A and B exchanged), mapped "
            "back, it says 0.0022 m deep: a difference of 0.0002 m.");
}

TEST(Variants, StateTheChangeThatTheMotionOfBExplains) {
  const ContactQuery asked = SphereInBoxFace(2e-3).query;
  const Plant jumps = [&](const ContactQuery& query, ContactAnswer& answer) {
    const double moved = (query.B.X_WB.p_WB - asked.B.X_WB.p_WB).norm();
    if (moved > 0 && moved < 1e-4) *answer.separation -= 1e-3;
    answer.points.clear();
  };
  const std::vector<Finding> findings = Judged(asked, jumps);
  ASSERT_THAT(Failed(findings), ElementsAre(MeasureKind::kPerturbation));
  EXPECT_THAT(findings.back().proof, HasSubstr("(perturbation: B moved by ("));
  EXPECT_THAT(findings.back().proof,
              HasSubstr(" m, of which the motion itself explains up to "));
}

TEST(Variants, CallAnAnswerThatLacksAFieldOfTheFirstInvalid) {
  const Plant sphere_first_says_only_that = [](const ContactQuery& query,
                                               ContactAnswer& answer) {
    if (KindOf(query.A.shape) != ShapeKind::kSphere) return;
    answer.separation.reset();
    answer.points.clear();
  };
  const std::vector<Finding> findings =
      Judged(SphereInBoxFace(2e-3).query, sphere_first_says_only_that);
  ASSERT_THAT(Failed(findings), ElementsAre(MeasureKind::kSwap));
  EXPECT_EQ(findings[0].verdict, Verdict::kInvalid);
  EXPECT_EQ(findings[0].proof,
            "mine answers the question, but not its variant (swap: A and B "
            "exchanged): it returns no separation.");
}

TEST(Variants, VerifyNothingWhereNothingIsCompared) {
  const Plant says_only_that = [](const ContactQuery&, ContactAnswer& answer) {
    answer.separation.reset();
    answer.n_AB_W.reset();
    answer.witnesses.reset();
    answer.points.clear();
  };
  // Only the touching verdict is compared, and it can be wrong only away from touching.
  EXPECT_EQ(Judged(SphereInBoxFace(2e-3).query, says_only_that).size(), 5U);
  EXPECT_THAT(Judged(SphereInBoxFace(0).query, says_only_that), IsEmpty());
}

TEST(Variants, ReportAnEngineThatCrashesOnOne) {
  const Plant dies = [](const ContactQuery& query, ContactAnswer& answer) {
    if (KindOf(query.A.shape) == ShapeKind::kSphere) {
      answer = {};
      answer.status = AnswerStatus::kCrashed;
      answer.reason = "signal 11";
    }
  };
  const std::vector<Finding> findings = Judged(SphereInBoxFace(2e-3).query, dies);
  ASSERT_THAT(Failed(findings), ElementsAre(MeasureKind::kSwap));
  EXPECT_EQ(findings[0].verdict, Verdict::kCrashed);
  EXPECT_EQ(findings[0].proof,
            "mine answers the question, but not its variant (swap: A and B "
            "exchanged): signal 11.");
}

}  // namespace
}  // namespace touchstone
