#include "reports/triage/root.h"

#include <functional>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/no_answer.h"
#include "reports/shrink/shrink.h"
#include "reports/triage/known_faults.h"
#include "reports/triage/root_files.h"
#include "reports/triage/triage_index.h"
#include "scenarios/scenario_file.h"
#include "tests/reports/fake_oracle.h"
#include "tests/reports/triage/boxes_and_balls.h"

namespace touchstone {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/** Returns an oracle of `library` that is wrong as `plant` says. */
FakeOracle Of(const std::string& name, const std::string& library,
              const std::function<void(const ContactQuery&, ContactAnswer&)>& plant) {
  FakeOracle oracle = FakeOracle::Wrong(name, plant);
  oracle.info().library = library;
  oracle.info().version = "1.2";
  return oracle;
}

void DoubleTheDepth(const ContactQuery&, ContactAnswer& answer) {
  if (answer.touching && answer.separation) *answer.separation *= 2;
}

Specimen SpecimenOf(const Scenario& question, const Oracle& oracle) {
  return SmallestIn(question, oracle);
}

const Scenario kBoxAndBall = BoxAnd(Sphere{0.5123}, {1.2345, 0.1, 0.2});
const Scenario kTwoBoxes = BoxAnd(Box{{0.5, 0.6, 0.7}}, {1.2345, 0.1, 0.2});

// One iterative algorithm for all shapes.
TEST(Roots, JoinPairsOfShapesAndOraclesOfALibrary) {
  const FakeOracle one = Of("lib/one", "Lib", DoubleTheDepth);
  const FakeOracle two = Of("lib/two", "Lib", DoubleTheDepth);
  const std::vector<Root> roots =
      RootsAmongBoxesAndBalls({SpecimenOf(kBoxAndBall, one), SpecimenOf(kTwoBoxes, one),
                               SpecimenOf(kTwoBoxes, two)});
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].specimens.size(), 3U);
  EXPECT_THAT(OraclesOf(roots[0]), ElementsAre("lib/one", "lib/two"));
  EXPECT_THAT(TitleOf(roots[0]),
              AllOf(HasSubstr("Lib 1.2"), HasSubstr("(certified) states a wrong depth")));
  // A series counts once for each oracle; the two symptoms of `one` are of one series.
  // The families and pairs in which none failed may show it, too.
  EXPECT_EQ(roots[0].rate.asked, 500U);
  EXPECT_EQ(roots[0].rate.failed, 15U);
  EXPECT_EQ(roots[0].rates.size(), 6U);
}

TEST(Roots, TellLibrariesFaultsAndPlacesApart) {
  const FakeOracle deep = Of("a", "A", DoubleTheDepth);
  const FakeOracle other = Of("b", "B", DoubleTheDepth);
  const FakeOracle blind = Of("c", "A", [](const ContactQuery&, ContactAnswer& answer) {
    answer = {};
    answer.status = AnswerStatus::kAnswered;
  });
  const auto crash = [](const char* how) {
    return [how](const ContactQuery&, ContactAnswer& answer) {
      answer = CrashedAnswer(how);
    };
  };
  const FakeOracle here = Of("d", "A", crash("aborted: gjk.h:12: Assertion `a' failed"));
  const FakeOracle there = Of("e", "A", crash("aborted: epa.h:34: Assertion `b' failed"));
  std::vector<Specimen> specimens;
  for (const Oracle* const oracle :
       std::initializer_list<const Oracle*>{&deep, &other, &blind, &here, &there}) {
    specimens.push_back(SpecimenOf(kBoxAndBall, *oracle));
  }
  const std::vector<Root> roots = RootsAmongBoxesAndBalls(std::move(specimens));
  ASSERT_EQ(roots.size(), 5U);
  std::set<std::string> folders;
  for (const Root& root : roots) folders.insert(FolderOf(root));
  EXPECT_EQ(folders.size(), 5U);
  EXPECT_THAT(folders,
              testing::Contains(HasSubstr("aborted_gjk_h_12_assertion_a_failed")));
  for (const std::string& folder : folders) {
    EXPECT_LE(folder.size(), 80U);
    EXPECT_EQ(folder.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
              std::string::npos)
        << folder;
  }
  // Missing answers and misses come before wrong depths.
  EXPECT_EQ(roots[0].grade, Grade::kUnusable);
  EXPECT_EQ(roots[2].grade, Grade::kWrongTouch);
  EXPECT_LT(roots[4].grade, Grade::kWrongTouch);
}

TEST(Roots, OfTwoVersionsOfALibraryAreTwo) {
  const FakeOracle old = Of("lib", "Lib", DoubleTheDepth);
  FakeOracle recent = Of("lib@2", "Lib", DoubleTheDepth);
  recent.info().version = "2.0";
  const std::vector<Root> roots = RootsAmongBoxesAndBalls(
      {SpecimenOf(kBoxAndBall, old), SpecimenOf(kBoxAndBall, recent)});
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_NE(TitleOf(roots[0]), TitleOf(roots[1]));
  EXPECT_EQ(KeyLinesOf(roots[0]), KeyLinesOf(roots[1]));
}

TEST(RootFiles, SayThatTheSearchForASmallerQuestionEndedEarly) {
  const FakeOracle oracle = Of("lib/one", "Lib", DoubleTheDepth);
  const Specimen asked = AskAgain(SymptomIn(kBoxAndBall, oracle), oracle);
  const auto report = [](const Specimen& specimen) {
    const Root root = RootsAmongBoxesAndBalls({specimen}).at(0);
    return ReportOf(root, ProgramOf(root), std::nullopt, {});
  };
  EXPECT_THAT(report(Smallest(asked, {})), testing::Not(HasSubstr("ended early")));
  EXPECT_THAT(report(Smallest(asked, {.tries = 1})), HasSubstr("ended early"));
  EXPECT_THAT(report(asked), HasSubstr("ended early"));
}

TEST(Roots, OfClosedFormsAreOfTheirShapes) {
  FakeOracle oracle = Of("lib/one", "Lib", DoubleTheDepth);
  oracle.ForEachPair([](Capability& capability) { capability.family = "closed_form"; });
  const Specimen ball = AskAgain(SymptomIn(kBoxAndBall, oracle), oracle);
  const Specimen box = AskAgain(SymptomIn(kTwoBoxes, oracle), oracle);
  EXPECT_EQ(Joined({ball, box}).size(), 2U);
  EXPECT_EQ(Joined({ball, box, ball}).size(), 2U);
  EXPECT_EQ(Joined({ball, box, ball}).front().symptoms.size(), 2U);
  EXPECT_EQ(KeyOf(ball).shapes, "box and sphere");
  // A cone runs into other code.
  const std::vector<Root> roots = RootsAmongBoxesAndBalls({ball});
  EXPECT_EQ(roots.at(0).rate.asked, 200U);
}

// One function is mended at once, whatever goes wrong in it.
TEST(Roots, OfAClosedFormHaveAllThatGoesWrong) {
  const auto closed = [](FakeOracle oracle) {
    oracle.ForEachPair([](Capability& capability) { capability.family = "closed_form"; });
    return oracle;
  };
  const FakeOracle deep = closed(Of("deep", "Lib", DoubleTheDepth));
  const FakeOracle blind =
      closed(Of("blind", "Lib", [](const ContactQuery&, ContactAnswer& answer) {
        answer = {};
        answer.status = AnswerStatus::kAnswered;
      }));
  const auto crash = [](const ContactQuery&, ContactAnswer& answer) {
    answer = CrashedAnswer("aborted: box.h:12: Assertion `a' failed");
  };
  const FakeOracle broken = closed(Of("broken", "Lib", crash));
  const auto specimen = [](const Oracle& oracle) {
    return AskAgain(SymptomIn(kBoxAndBall, oracle), oracle);
  };
  const std::vector<Specimen> joined =
      Joined({specimen(blind), specimen(deep), specimen(broken)});
  ASSERT_EQ(joined.size(), 2U);  // An assertion is a place of its own.
  EXPECT_EQ(joined[0].symptoms.size(), 2U);
  const std::vector<Root> roots = RootsAmongBoxesAndBalls({joined[0]});
  EXPECT_THAT(TitleOf(roots.at(0)),
              HasSubstr("(closed_form) misses a contact, states a wrong depth: box and"));
  EXPECT_THAT(FolderOf(roots[0]), HasSubstr("closed_form_is_wrong_box_and_sphere"));
  EXPECT_EQ(roots[0].rate.failed, 10U);
  // Another failure of a function that has failed before is new.
  EXPECT_THAT(
      KeyLinesOf(roots[0]),
      ElementsAre("Lib | closed_form | misses a contact |  | box and sphere",
                  "Lib | closed_form | states a wrong depth |  | box and sphere"));
}

// So is an algorithm that an oracle has for one pair, such as boxes by their axes.
TEST(Roots, OfAnAlgorithmForOnePairAreOfItsShapes) {
  FakeOracle oracle = Of("lib/one", "Lib", DoubleTheDepth);
  const auto of_boxes = [&oracle](ShapeKind a, ShapeKind b, const char* family) {
    oracle.info()
        .capabilities[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)]
        .family = family;
  };
  of_boxes(ShapeKind::kBox, ShapeKind::kBox, "sat");
  const Specimen boxes = AskAgain(SymptomIn(kTwoBoxes, oracle), oracle);
  EXPECT_EQ(KeyOf(boxes).shapes, "box and box");
  EXPECT_EQ(KeyOf(boxes).failure, "is wrong");
  of_boxes(ShapeKind::kCone, ShapeKind::kCone, "sat");
  EXPECT_EQ(KeyOf(boxes).shapes, "");
  EXPECT_EQ(KeyOf(boxes).failure, "states a wrong depth");
}

TEST(Roots, LeaveOutWhatIsNotRepeated) {
  Specimen specimen;
  EXPECT_TRUE(RootsAmongBoxesAndBalls({specimen}).empty());
}

TEST(RootFiles, HaveACaseThatShowsTheFaultAgain) {
  const FakeOracle oracle = Of("lib/one", "Lib", DoubleTheDepth);
  const std::vector<Root> roots =
      RootsAmongBoxesAndBalls({SpecimenOf(kBoxAndBall, oracle)});
  const ReadResult read =
      ReadScenario(CaseFile(roots.at(0), "triage/lib/case"), "case.toml");
  ASSERT_TRUE(read.diagnostics.empty()) << ToString(read.diagnostics.front());
  const RunReport report = AskAlone(read.scenario.value(), oracle);
  EXPECT_THAT(report.faults, testing::IsEmpty());  // The indictment is confirmed.
  EXPECT_EQ(read.scenario->id, "triage/lib/case");
}

TEST(RootFiles, HaveAReportWithRateNeighbourhoodAndWhatIsKnown) {
  const FakeOracle oracle = Of("lib/one", "Lib", DoubleTheDepth);
  const Root root = RootsAmongBoxesAndBalls({SpecimenOf(kBoxAndBall, oracle)}).at(0);
  const RootProgram program = ProgramOf(root);
  EXPECT_FALSE(program.files);  // Nobody has a program for a library of a test.
  EXPECT_NE(program.reason, "");
  EXPECT_THAT(
      ReportOf(root, program, std::nullopt, {}),
      AllOf(HasSubstr("# Lib 1.2"), HasSubstr("## Answer and proof"),
            HasSubstr("random, box and sphere | 5 of 100, 5 %"),
            HasSubstr("all | the others | 0 of 150, 0 %"), HasSubstr("5 of 250 answers"),
            HasSubstr("is in 20 of 20 questions"), HasSubstr("has none like it")));
  EXPECT_THAT(ReportOf(root, program, std::nullopt, {"It doubles depths. (unreported)"}),
              HasSubstr("- It doubles depths. (unreported)"));
}

TEST(RootFiles, SayHowTheProgramEnded) {
  const FakeOracle oracle = Of("lib/one", "Lib", DoubleTheDepth);
  const Root root = RootsAmongBoxesAndBalls({SpecimenOf(kBoxAndBall, oracle)}).at(0);
  const RootProgram program{.files = Reproduction{.program = "int main() {}",
                                                  .build = "project(x)",
                                                  .title = "A title",
                                                  .report = "## Asked\n\n"},
                            .reason = ""};
  const auto report = [&](ProgramEnding ending) {
    return ReportOf(root, program, ProgramOutput{"one\ntwo", ending}, {});
  };
  EXPECT_THAT(report(ProgramEnding::kShowsFault),
              AllOf(HasSubstr("## Asked\n\n## Output\n\n    one\n    two\n"),
                    testing::Not(HasSubstr("A title"))));
  EXPECT_THAT(report(ProgramEnding::kShowsNone), HasSubstr("does not show the fault"));
  EXPECT_THAT(report(ProgramEnding::kNotBuilt), HasSubstr("could not be built"));
  EXPECT_THAT(report(ProgramEnding::kUnfinished), HasSubstr("did not come to its end"));
}

TEST(KnownFaults, AreThoseOfTheOraclesVerdictsAndMeasuresOfARoot) {
  const FakeOracle oracle = Of("lib/one", "Lib", DoubleTheDepth);
  const Root root = RootsAmongBoxesAndBalls({SpecimenOf(kBoxAndBall, oracle)}).at(0);
  Ledger ledger;
  LedgerEntry& entry = ledger.entries.emplace_back();
  entry.oracle = "lib/one";
  entry.version = "1.2";
  entry.measures = {MeasureKind::kExcess, root.smallest().finding.measure};
  entry.fault = "It doubles depths.";
  entry.upstream = "owner/repo#1";
  entry.scenarios = {"contact/box_*/**"};
  Scenario listed = kBoxAndBall;
  listed.id = std::string("contact/box_sphere/deep");
  const Questions catalogue{.contacts = {listed}, .worlds = {}};
  EXPECT_THAT(KnownFaultsLike(root, ledger, catalogue),
              ElementsAre("It doubles depths. (owner/repo#1)"));
  // No question of the catalogue that the entry is about may show it.
  EXPECT_TRUE(KnownFaultsLike(root, ledger, {}).empty());
  for (const auto& change : std::initializer_list<std::function<void(LedgerEntry&)>>{
           [](LedgerEntry& e) { e.version = "1.3"; },
           [](LedgerEntry& e) { e.oracle = "lib/two"; },
           [](LedgerEntry& e) { e.measures = {MeasureKind::kExcess}; },
           [](LedgerEntry& e) { e.verdict = Verdict::kCrashed; },
           [](LedgerEntry& e) { e.scenarios = {"contact/cone_*/**"}; }}) {
    Ledger other = ledger;
    change(other.entries.front());
    EXPECT_TRUE(KnownFaultsLike(root, other, catalogue).empty());
  }
}

}  // namespace
}  // namespace touchstone
