// Ten faults, each put into an engine that is otherwise right: a sweep over all families
// and all pairs of shapes must end in one root cause each, named after the fault.

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/no_answer.h"
#include "reports/sweep/sweep.h"
#include "reports/triage/root_files.h"
#include "reports/triage/sweep_failures.h"
#include "scenarios/generators/generate.h"
#include "tests/reports/fake_oracle.h"

namespace touchstone {
namespace {

/** Changes a right answer into a wrong one. */
using Plant = void (*)(const ContactQuery&, ContactAnswer&);

/** A fault, and the words that its root cause must be found by. */
struct Injected {
  const char* name;
  Plant plant;
  std::vector<std::string> title;
};

bool Has(const ContactQuery& query, ShapeKind kind) {
  return KindOf(query.A.shape) == kind || KindOf(query.B.shape) == kind;
}

bool AreBoth(const ContactQuery& query, ShapeKind kind) {
  return KindOf(query.A.shape) == kind && KindOf(query.B.shape) == kind;
}

/** Returns the depth over the radius of the smaller body. [-] */
double DepthOf(const ContactQuery& query, const ContactAnswer& answer) {
  double smaller = std::numeric_limits<double>::infinity();
  for (const Body* const body : {&query.A, &query.B}) {
    if (KindOf(body->shape) != ShapeKind::kHalfSpace)
      smaller = std::min(smaller, BoundingRadius(body->shape));
  }
  return -*answer.separation / smaller;
}

const std::vector<Injected> kInjected = {
    {"AnAssertionInDeepContacts",
     [](const ContactQuery& query, ContactAnswer& answer) {
       if (DepthOf(query, answer) > 0.5)
         answer = CrashedAnswer("aborted: epa.h:123: Assertion `closed' failed");
     },
     {"gives no usable answer", "epa.h:123", "closed"}},
    {"AHangOfTwoCones",
     [](const ContactQuery& query, ContactAnswer& answer) {
       if (AreBoth(query, ShapeKind::kCone) && answer.touching)
         answer = TimedOutAnswer("no answer after 2 s of CPU time");
     },
     {"gives no usable answer", "no answer after"}},
    {"DepthsOfBoxesTwiceTooLarge",
     [](const ContactQuery& query, ContactAnswer& answer) {
       if (!AreBoth(query, ShapeKind::kBox) || !answer.touching) return;
       *answer.separation *= 2;
       for (ContactPoint& point : answer.points) point.separation *= 2;
     },
     {"states a wrong depth"}},
    {"ContainedBodiesThatAreMissed",
     [](const ContactQuery& query, ContactAnswer& answer) {
       if (!Has(query, ShapeKind::kCylinder) || DepthOf(query, answer) < 0.5) return;
       answer = {};
       answer.status = AnswerStatus::kAnswered;
     },
     {"misses a contact"}},
    {"AMarginOfTwoPercent",
     [](const ContactQuery& query, ContactAnswer& answer) {
       const double depth = DepthOf(query, answer);
       if (!Has(query, ShapeKind::kConvexHull) || depth > 0 || depth < -0.02) return;
       answer.touching = true;
       answer.points = {{(answer.witnesses->p_WCa + answer.witnesses->p_WCb) / 2, 0, {}}};
     },
     {"reports a contact where there is none"}},
    {"NormalsOfConesAskew",
     [](const ContactQuery& query, ContactAnswer& answer) {
       if (!Has(query, ShapeKind::kCone) || !answer.touching) return;
       const Eigen::Vector3d& n_W = *answer.n_AB_W;
       const Eigen::Vector3d askew_W = n_W + 0.5 * n_W.unitOrthogonal();
       answer.n_AB_W = askew_W.normalized();
     },
     {"gives a wrong normal"}},
    {"ContactsInTheMiddleOfB",
     [](const ContactQuery& query, ContactAnswer& answer) {
       if (!Has(query, ShapeKind::kCapsule)) return;
       for (ContactPoint& point : answer.points) point.p_WC = query.B.X_WB.p_WB;
     },
     {"gives wrong contact points"}},
    {"DistancesWithoutTheRadius",
     [](const ContactQuery& query, ContactAnswer& answer) {
       const auto* const ball = std::get_if<Sphere>(&query.A.shape);
       if (ball != nullptr && !answer.touching) *answer.separation += ball->radius;
     },
     {"states a wrong distance"}},
    {"NearestPointsExchanged",
     [](const ContactQuery& query, ContactAnswer& answer) {
       if (answer.witnesses && Has(query, ShapeKind::kSphere))
         std::swap(answer.witnesses->p_WCa, answer.witnesses->p_WCb);
     },
     {"gives wrong nearest points"}},
    {"ADepthThatIsNoNumber",
     [](const ContactQuery& query, ContactAnswer& answer) {
       if (answer.touching && Has(query, ShapeKind::kHalfSpace))
         *answer.separation = std::numeric_limits<double>::quiet_NaN();
     },
     {"gives no usable answer", "separation"}},
};

class AnInjectedFault : public testing::TestWithParam<Injected> {};

std::vector<Root> RootsOfANight(const Oracle& oracle) {
  SweepPlan plan;
  plan.subjects = {&oracle};
  for (const Family family : AllFamilies()) {
    for (int a = 0; a < kShapeKinds; ++a) {
      for (int b = 0; b < kShapeKinds; ++b) {
        const auto A = static_cast<ShapeKind>(a);
        const auto B = static_cast<ShapeKind>(b);
        if (A == ShapeKind::kHalfSpace && B == ShapeKind::kHalfSpace) continue;
        plan.series.emplace_back(
            QuestionSeries{.family = family, .A = A, .B = B, .count = 4});
      }
    }
  }
  SweepFile file = SweepFile::Create(":memory:", SettingsOf(plan), SweepJournal::kNone);
  Sweep(plan, file, {});
  const Failures failures = FailuresOf(file, {oracle.info().name});
  std::vector<Specimen> specimens;
  for (const Symptom& symptom : failures.symptoms)
    specimens.push_back(AskAgain(symptom, oracle));
  specimens = Joined(std::move(specimens));
  for (Specimen& specimen : specimens) {
    EXPECT_TRUE(specimen.is_repeatable);
    specimen = Smallest(std::move(specimen), {.tries = 30});
  }
  const Oracle* const oracles[] = {&oracle};
  std::vector<Root> roots = RootsOf(std::move(specimens), failures.asked, oracles);
  std::uint64_t covered = 0;
  for (const Root& root : roots) covered += root.rate.failed + root.in_variants;
  EXPECT_EQ(covered, failures.failed);
  return roots;
}

TEST(ARightEngine, HasNoRootCause) {
  for (const Root& root : RootsOfANight(FakeOracle("engine"))) {
    ADD_FAILURE() << TitleOf(root) << ": " << root.rate.failed << "; "
                  << root.smallest().finding.proof << CaseFile(root, "case");
  }
}

TEST_P(AnInjectedFault, IsOneRootCauseOfItsName) {
  const FakeOracle oracle = FakeOracle::Wrong("engine", GetParam().plant);
  const std::vector<Root> roots = RootsOfANight(oracle);
  for (const Root& root : roots) {
    if (roots.size() != 1)
      ADD_FAILURE() << TitleOf(root) << ": " << root.rate.failed << " of "
                    << root.rate.asked << "; " << root.smallest().finding.proof;
  }
  ASSERT_EQ(roots.size(), 1U);
  for (const std::string& words : GetParam().title)
    EXPECT_THAT(TitleOf(roots[0]), testing::HasSubstr(words));
}

// Neither follows from the other: the depth is off by a part of the depth, the contacts
// are off by the size of the body.
TEST(TwoInjectedFaults, AreTwoRootCauses) {
  const FakeOracle oracle =
      FakeOracle::Wrong("engine", [](const ContactQuery& query, ContactAnswer& answer) {
        if (!AreBoth(query, ShapeKind::kSphere) || !answer.touching) return;
        const double depth = DepthOf(query, answer);
        if (depth < 0.2) *answer.separation *= 1.02;
        if (depth > 0.2) {
          for (ContactPoint& point : answer.points)
            point.p_WC = query.A.X_WB.p_WB + query.B.X_WB.p_WB;
        }
      });
  std::vector<std::string> titles;
  for (const Root& root : RootsOfANight(oracle)) titles.push_back(TitleOf(root));
  EXPECT_THAT(titles, testing::UnorderedElementsAre(
                          testing::HasSubstr("states a wrong depth"),
                          testing::HasSubstr("gives wrong contact points")));
}

// A contact far off is not explained by a depth that is off by a fiftieth.
TEST(AFaultOfTheContacts, IsNotOneOfADepthThatIsLessWrong) {
  const FakeOracle oracle =
      FakeOracle::Wrong("engine", [](const ContactQuery& query, ContactAnswer& answer) {
        if (!AreBoth(query, ShapeKind::kSphere) || !answer.touching) return;
        *answer.separation *= 1.02;
        for (ContactPoint& point : answer.points) {
          point.separation = *answer.separation;
          point.p_WC += 2 * std::get<Sphere>(query.A.shape).radius *
                        answer.n_AB_W->unitOrthogonal();
        }
      });
  const std::vector<Root> roots = RootsOfANight(oracle);
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_THAT(TitleOf(roots[0]), testing::HasSubstr("gives wrong contact points"));
}

INSTANTIATE_TEST_SUITE_P(Triage, AnInjectedFault, testing::ValuesIn(kInjected),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace touchstone
