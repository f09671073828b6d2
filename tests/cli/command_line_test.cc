#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "programs.h"
#include "run_program.h"
#include "tests/source_tree.h"
#include "without_seconds.h"

namespace touchstone {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Two spheres of radius 0.5 m, centres 0.9 m apart along (2, -1, 2)/3: 0.1 m deep.
constexpr const char* kDeep = R"(id = "mine/deep"
title = "Two balls, a tenth of a metre deep"
source = "Centres 0.9 m apart, radii 0.5 m"

[bodies.ball]
shape = "sphere"
radius = 0.5
position = [0.3, -0.2, 0.7]
quaternion = [0.4, -0.2, 0.8, 0.4]

[bodies.other]
shape = "sphere"
radius = 0.5
position = [0.9, -0.5, 1.3]
quaternion = [0.4, -0.2, 0.8, 0.4]

[contact]
A = "ball"
B = "other"

[expect]
touching = true
)";

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string TextOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class CommandLineTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("command_line_test_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "mine");
    Write("mine/deep.toml", kDeep);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }

  std::string Command(const std::string& arguments) const {
    return ProgramWithFaults() + " " + arguments;
  }

  Ended Touchstone(const std::string& arguments) const {
    return InPipe(Command(arguments));
  }

  // Runs the program with every engine.
  Ended Itself(const std::string& arguments) const {
    return InPipe(TouchstoneProgram() + " " + arguments);
  }

  std::filesystem::path folder_;
};

TEST_F(CommandLineTest, ExitsWithZeroIfTheSubjectIsRight) {
  const Ended ended = Touchstone("run --fail-on subject " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out,
              HasSubstr("OK: right never failed (it answers the only scenario); "));
}

TEST_F(CommandLineTest, ExitsWithTwoIfItsOutputIsLost) {
  const Ended ended =
      InPipe("(" + Command("run " + Path("mine/deep.toml")) + " >/dev/full)");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("the output cannot be written"));
}

TEST_F(CommandLineTest, ExitsWithOneAndAProofIfTheSubjectIsWrong) {
  const Ended ended = Touchstone("run --subject half_depth " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("half_depth: fail, over 0.001 in "),
                               HasSubstr("Proof: half_depth says")));
}

// The spheres are 0.1 m deep in each other, and half_depth says 0.05 m. A tolerance that
// wide decides nothing.
TEST_F(CommandLineTest, GrantsTheSubjectAStatedToleranceAndNoMoreAndSaysSo) {
  const std::string file = " --subject half_depth " + Path("mine/deep.toml");
  const Ended granted = Touchstone("run --fail-on subject --tolerance 0.0501" + file);
  EXPECT_EQ(granted.code, 2) << granted.out << granted.err;
  EXPECT_THAT(granted.out, HasSubstr("the only answer of half_depth is undecidable"));
  EXPECT_THAT(granted.out, HasSubstr("Granted to half_depth beyond rounding: 0.0501 m, "
                                     "stated by --tolerance"));
  const Ended refused = Touchstone("run --tolerance 0.0499" + file);
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.out, HasSubstr("0.0499 m stated by --tolerance)"));
  EXPECT_EQ(Touchstone("run --fail-on subject --tolerance-share 0.5" + file).code, 2);
  EXPECT_EQ(Touchstone("run --fail-on subject --tolerance-share 0.001" + file).code, 1);
  EXPECT_THAT(Touchstone("explain --tolerance 0.0501" + file).out,
              AllOf(HasSubstr("Granted to half_depth"), Not(HasSubstr("Wrong: half"))));
  EXPECT_THAT(Touchstone("run" + file).out, Not(HasSubstr("Granted")));
}

/** Runs six worlds, and kills the program once the file that keeps them has grown. */
constexpr const char* kKilled = R"sh(sh -c '
"$0" run "world/impact/oblique*" --jobs 1 --quiet --out "$1" &
while [ "$(stat -c %s "$1/run.unfinished.sqlite-wal" 2>/dev/null || echo 0)" -lt 200000 ]
do kill -0 $! 2>/dev/null || exit 9; sleep 0.01; done
kill -KILL $!; wait $!' )sh";

TEST_F(CommandLineTest, GoesOnWithARunThatWasKilledAndEndsWithTheSameReport) {
  const std::string run = "run 'world/impact/oblique*' --quiet --out ";
  const Ended whole = Itself(run + Path("whole"));
  const Ended killed = InPipe(kKilled + TouchstoneProgram() + " " + Path("killed"));
  EXPECT_EQ(killed.code, 137) << killed.err;
  EXPECT_TRUE(std::filesystem::exists(Path("killed/run.unfinished.sqlite")));
  const Ended resumed = Itself(run + Path("killed") + " --resume");
  EXPECT_EQ(resumed.code, whole.code);
  for (const char* file : {"/report.jsonl", "/report.data", "/junit.xml"})
    EXPECT_EQ(WithoutSeconds(Path("killed") + file), WithoutSeconds(Path("whole") + file))
        << file;
  EXPECT_FALSE(std::filesystem::exists(Path("killed/run.unfinished.sqlite")));
}

TEST_F(CommandLineTest, ExitsWithTwoIfAToleranceIsNoLength) {
  for (const char* text : {"-1", "nan", "inf", "1e-4m"}) {
    const Ended ended = Touchstone(std::string("run --tolerance=") + text);
    EXPECT_EQ(ended.code, 2) << text;
    EXPECT_THAT(ended.err, HasSubstr("expected a finite number >= 0")) << text;
  }
}

TEST_F(CommandLineTest, CountsAReferencesFailureUnlessOnlyTheSubjectsCount) {
  const std::string run = "run --against half_depth " + Path("mine/deep.toml");
  const Ended ended = Touchstone(run);
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out,
              HasSubstr("--fail-on subject counts only the failures of right"));
  EXPECT_EQ(Touchstone(run + " --fail-on anything").code, 1);
  EXPECT_EQ(Touchstone(run + " --fail-on subject").code, 0);
}

TEST_F(CommandLineTest, CountsFailuresAboveAGradeOnly) {
  const std::string run =
      "run --subject half_depth --against right " + Path("mine/deep.toml");
  EXPECT_EQ(Touchstone(run + " --fail-above 1e-6").code, 1);
  EXPECT_EQ(Touchstone(run + " --fail-above 1e-3").code, 1);
  EXPECT_EQ(Touchstone(run + " --fail-above touching").code, 0);
  const Ended ended = Touchstone(run + " --fail-above 0.1");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out,
              HasSubstr("--fail-above: no failure that counts is graver than 'over "
                        "0.001'\n"));
  EXPECT_EQ(
      Touchstone("run --subject thrower --fail-above touching " + Path("mine/deep.toml"))
          .code,
      1);
}

TEST_F(CommandLineTest, ReportsAnExceptionOfAFunctionAndContinues) {
  const Ended ended = Touchstone("run --subject thrower " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("1 crashed"));
}

TEST_F(CommandLineTest, ExitsWithTwoIfNothingWasVerified) {
  Write(
      "mine/boxes.toml",
      Replaced(Replaced(Replaced(kDeep, "mine/deep", "mine/boxes"),
                        "\"sphere\"\nradius = 0.5", "\"box\"\nhalf_extents = [1, 2, 3]"),
               "\"sphere\"\nradius = 0.5", "\"box\"\nhalf_extents = [1, 2, 3]"));
  const Ended ended = Touchstone("run " + Path("mine/boxes.toml"));
  EXPECT_EQ(ended.code, 2) << ended.out;
  EXPECT_THAT(ended.out, HasSubstr("right was not examined: unsupported: "));
}

TEST_F(CommandLineTest, ShowsTheExpectationThatTheTruthContradicts) {
  Write("mine/deep.toml", std::string(kDeep) + "separation = -0.2\n");
  const Ended ended = Touchstone("run --fail-on subject " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("\nFaults in the scenario files and the ledger, not in an "
                              "engine\n"),
                    HasSubstr(Path("mine/deep.toml") +
                              ":23:14: expects separation = -0.2 m, but it is")));
}

TEST_F(CommandLineTest, NamesTheNearestOracle) {
  const Ended ended = Touchstone("run --subject half_dept " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("no oracle 'half_dept' (did you mean half_depth?)"));
  EXPECT_EQ(ended.out, "");
}

TEST_F(CommandLineTest, NamesTheNearestScenario) {
  const Ended ended = Touchstone("run --catalogue " + folder_.string() + " mine/dep");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err,
              HasSubstr("no scenario matches 'mine/dep' (did you mean mine/deep?)"));
}

TEST_F(CommandLineTest, SuggestsTheFolderWithTheShapesInTheOtherOrder) {
  std::filesystem::create_directories(folder_ / "contact/sphere_box");
  Write("contact/sphere_box/deep.toml",
        Replaced(kDeep, "mine/deep", "contact/sphere_box/deep"));
  const auto error = [this](const std::string& pattern) {
    return Touchstone("run --catalogue " + folder_.string() + " '" + pattern + "'").err;
  };
  EXPECT_THAT(error("contact/box_sphere/*"),
              HasSubstr("(did you mean contact/sphere_box/*?)"));
  EXPECT_THAT(error("contact/box_sphere"), HasSubstr("contact/sphere_box?)"));
  EXPECT_THAT(error("contact/box_sphere/deep"), HasSubstr("contact/sphere_box/deep?)"));
  EXPECT_THAT(error("contact/sphere_bxo/*"),
              HasSubstr("(did you mean contact/sphere_box/*?)"));
}

TEST_F(CommandLineTest, ListsTheErrataIfASpecimenIsUnknown) {
  const Ended ended = Itself("run --subject printed:E-99");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err,
              AllOf(HasSubstr("no oracle 'printed:E-99' (did you mean printed:E-09?)"),
                    HasSubstr("expected one of: printed, printed:none, printed:E-01, ")));
}

TEST_F(CommandLineTest, SelectsByFolderAndGlob) {
  Write("mine/other.toml", Replaced(kDeep, "mine/deep", "mine/other"));
  const std::string list = "list --catalogue " + folder_.string();
  EXPECT_THAT(Touchstone(list).out, HasSubstr("2  scenarios"));
  EXPECT_THAT(Touchstone(list + " mine").out, HasSubstr("2  scenarios"));
  EXPECT_THAT(Touchstone(list + " 'mine/*p'").out,
              AllOf(HasSubstr("mine/deep"), HasSubstr("1  scenario\n")));
  EXPECT_EQ(Touchstone(list + " '*p'").code, 2) << "* stays within a level";
}

TEST_F(CommandLineTest, RefusesTheRunAndNamesEveryErrorOfABrokenFile) {
  Write("mine/broken.toml", Replaced(Replaced(kDeep, "radius = 0.5", "radius = -0.5"),
                                     "B = \"other\"", "B = \"othr\""));
  const Ended ended = Touchstone("run --out " + Path("report") + " " + Path("mine"));
  EXPECT_EQ(ended.code, 2);
  // The radius is in line 7, the name in line 19. The id does not match the path either.
  EXPECT_THAT(ended.err, AllOf(HasSubstr("broken.toml:7:"), HasSubstr("broken.toml:19:"),
                               HasSubstr("nothing was run")));
  EXPECT_EQ(ended.out, "");
  EXPECT_FALSE(std::filesystem::exists(Path("report")));
}

TEST_F(CommandLineTest, RefusesAPathThatCannotBeResolved) {
  // A link to itself, and a name too long for a file.
  std::filesystem::create_symlink("ring", folder_ / "ring");
  EXPECT_EQ(Touchstone("run " + Path("ring")).code, 2);
  EXPECT_EQ(Touchstone("explain " + std::string(300, 'x')).code, 2);
  std::filesystem::create_directories(folder_ / "ringed");
  std::filesystem::create_symlink("report.html", folder_ / "ringed/report.html");
  const Ended ended =
      Touchstone("run --out " + Path("ringed") + " " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("cannot write "));
}

TEST_F(CommandLineTest, RefusesABrokenLedger) {
  Write("ledger.toml", "[[entry]]\nscenarios = 3\n");
  const Ended ended =
      Touchstone("run --ledger " + Path("ledger.toml") + " " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err,
              AllOf(HasSubstr("ledger.toml:2:"), HasSubstr("errors in the ledger: ")));
}

TEST_F(CommandLineTest, ProposesALedgerForTheUsersFolderThatExcusesItsFailures) {
  const std::string folder = Path("mine");
  EXPECT_EQ(Touchstone("run " + folder).code, 1);
  const Ended proposed = Touchstone("ledger --propose " + folder);
  EXPECT_EQ(proposed.code, 0) << proposed.err;
  EXPECT_THAT(proposed.out,
              AllOf(HasSubstr("scenarios = \"mine/deep\"\noracle = \"half_depth\""),
                    HasSubstr("oracle = \"thrower\""), Not(HasSubstr("\"right\""))));
  // A person adds the reason and the date of each of the two entries.
  std::string completed = proposed.out;
  for (int entry = 0; entry < 2; ++entry) {
    completed = Replaced(completed, "reason = \"\"", "reason = \"It is known.\"");
    completed = Replaced(completed, "expires = \"\"", "expires = 9999-12-31");
  }
  Write("ledger.toml", completed);
  const std::string known = " --ledger " + Path("ledger.toml") + " " + folder;
  // Without bounds nothing is excused.
  EXPECT_EQ(Touchstone("run" + known).code, 1);
  const Ended updated = Touchstone("ledger --update" + known);
  EXPECT_EQ(updated.code, 0) << updated.out << updated.err;
  EXPECT_THAT(updated.out, HasSubstr("ledger.bounds: "));
  const Ended run = Touchstone("run" + known);
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const Ended audit = Touchstone("ledger --audit" + known);
  EXPECT_EQ(audit.code, 0) << audit.out << audit.err;
  EXPECT_THAT(audit.out,
              AllOf(HasSubstr("An error of 0.001 of the scene would be seen in "
                              "100.00 % of "),
                    HasSubstr("\n0 contradictions of causes\n"),
                    HasSubstr("\n0 failures outside the ledger\n")));
  // The causes are those of the findings, and the program can write them.
  std::string ledger = TextOf(Path("ledger.toml"));
  const std::size_t cause = ledger.find("cause = ");  // That of half_depth.
  ledger.replace(cause, ledger.find('\n', cause) - cause, "cause = \"tie\"");
  Write("ledger.toml", ledger);
  EXPECT_EQ(Touchstone("ledger --audit" + known).code, 1);
  EXPECT_EQ(Touchstone("ledger --update --causes" + known).code, 0);
  EXPECT_EQ(Touchstone("ledger --audit" + known).code, 0);
  EXPECT_EQ(Touchstone("ledger --propose" + known).out.find("[[entry]]"),
            std::string::npos);
}

TEST_F(CommandLineTest, RefusesABrokenFileOfBounds) {
  Write("ledger.toml", "");
  Write("ledger.bounds", "mine/deep half_depth depth=1\n");
  const Ended ended =
      Touchstone("run --ledger " + Path("ledger.toml") + " " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("ledger.bounds:1:22: bound is \"depth=1\""));
}

TEST_F(CommandLineTest, RequiresOneActionOfTheLedger) {
  for (const std::string options :
       {"", " --propose --audit", " --audit --update", " --audit --causes"}) {
    const Ended ended = Touchstone("ledger" + options);
    EXPECT_EQ(ended.code, 2) << options;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  }
}

TEST_F(CommandLineTest, AuditsOnlyTheWholeCatalogueAndWithATable) {
  Write("accuracy.md", "# Accuracy\n");
  const Ended part =
      Touchstone("run --audit " + Path("accuracy.md") + " " + Path("mine"));
  EXPECT_EQ(part.code, 2);
  EXPECT_THAT(part.err, HasSubstr("--audit is about the whole built-in catalogue"));
  const Ended no_table = Touchstone("run --audit " + Path("nowhere.md"));
  EXPECT_EQ(no_table.code, 2);
  EXPECT_THAT(no_table.err, HasSubstr("cannot read " + Path("nowhere.md")));
}

TEST_F(CommandLineTest, NamesWhatGotWorseThanInABaseline) {
  const std::string file = " --against thrower " + Path("mine/deep.toml");
  EXPECT_EQ(Touchstone("run --out " + Path("before") + file).code, 1);
  const std::string baseline = " --baseline " + Path("before/report.jsonl");
  EXPECT_THAT(Touchstone("run" + baseline + file).out,
              Not(HasSubstr("Worse than in the baseline")));
  // Yesterday half_depth gave the whole depth.
  std::string yesterday = TextOf(Path("before/report.jsonl"));
  for (std::size_t at = 0; (at = yesterday.find("\"right\"", at)) != std::string::npos;)
    yesterday.replace(at, 7, "\"half_depth\"");
  Write("before/report.jsonl", yesterday);
  const Ended worse = Touchstone("run --subject half_depth" + baseline + file);
  EXPECT_EQ(worse.code, 1);
  EXPECT_THAT(worse.out, HasSubstr("mine/deep: half_depth separation_error: was pass, is "
                                   "fail\n"));
  const Ended missing = Touchstone("run --baseline " + Path("nowhere.json") + file);
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.json:1:1: cannot be read; expected a "
                                     "report.jsonl of `touchstone run --out DIR`"));
}

TEST_F(CommandLineTest, ComparesTwoOraclesOfOneRun) {
  Touchstone("run --subject right --against half_depth --out " + Path("both") + " " +
             Path("mine/deep.toml"));
  const std::string compare = "compare " + Path("both");
  const Ended worse = Touchstone(compare + " --oracle right --with half_depth");
  EXPECT_EQ(worse.code, 1) << worse.err;
  EXPECT_THAT(worse.out,
              HasSubstr("mine/deep: half_depth separation_error: was pass, is fail"));
  EXPECT_EQ(Touchstone(compare + " --oracle half_depth --with right").code, 0);
  const Ended nobody = Touchstone(compare + " --oracle right --with nobody");
  EXPECT_EQ(nobody.code, 2);
  EXPECT_THAT(nobody.err, HasSubstr("the run has no findings of nobody; expected one of: "
                                    "half_depth, right"));
  EXPECT_EQ(Touchstone(compare + " --oracle right").code, 2);
  EXPECT_EQ(Touchstone(compare).code, 2);
}

TEST_F(CommandLineTest, ComparesTwoRunsAndFailsWhatGotWorse) {
  const std::string file = " --against thrower " + Path("mine/deep.toml");
  Touchstone("run --subject right --out " + Path("right") + file);
  Touchstone("run --subject half_depth --out " + Path("wrong") + file);
  const Ended same = Touchstone("compare " + Path("right") + " " + Path("right"));
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_THAT(same.out,
              HasSubstr("0 worse, 0 no longer judged, 0 new, 0 gone, 0 better\n"));
  const Ended other = Touchstone(
      "compare " + Path("right") + " " + Path("wrong/report.data") + " --json " +
      Path("c.json") + " --junit " + Path("c.xml") + " --html " + Path("c.html"));
  // The oracle `right` passed in the earlier run; the later run does not ask it.
  EXPECT_EQ(other.code, 1) << other.err;
  EXPECT_THAT(other.out,
              HasSubstr("mine/deep: right separation_error: was pass, is not measured"));
  EXPECT_THAT(other.out, HasSubstr("mine/deep: half_depth separation_error: is fail"));
  EXPECT_THAT(TextOf(Path("c.json")), HasSubstr("\"kind\": \"new\""));
  EXPECT_THAT(TextOf(Path("c.json")), HasSubstr("\"kind\": \"no longer judged\""));
  EXPECT_THAT(TextOf(Path("c.xml")), Not(HasSubstr("failures=\"0\"")));
  EXPECT_THAT(TextOf(Path("c.html")), HasSubstr("id=\"report-data\">"));
  const Ended missing = Touchstone("compare " + Path("right") + " " + Path("nowhere"));
  EXPECT_EQ(missing.code, 2);
  EXPECT_EQ(missing.err, "touchstone: " + Path("nowhere") +
                             ":1:1: cannot be read; expected report.data of `touchstone "
                             "run --out DIR`, or that folder\n");
}

TEST_F(CommandLineTest, WritesThePageOfAnEarlierRunAgain) {
  Touchstone("run --out " + Path("out") + " " + Path("mine/deep.toml"));
  const Ended ended = Touchstone("report " + Path("out") + " -o " + Path("page.html"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(TextOf(Path("page.html")), TextOf(Path("out/report.html")));
  Write("out/report.data", "no data");
  EXPECT_EQ(Touchstone("report " + Path("out") + " -o " + Path("page.html")).code, 2);
  EXPECT_EQ(Touchstone("report " + Path("out")).code, 2);
}

TEST_F(CommandLineTest, AppliesTheBuiltInLedgerToTheBuiltInCatalogueOnly) {
  std::filesystem::create_directories(folder_ / "data/catalogue/mine");
  Write("data/catalogue/mine/known.toml", Replaced(kDeep, "mine/deep", "mine/known"));
  Write("data/known_discrepancies.toml", R"([[entry]]
scenarios = "mine/*"
oracle = "half_depth"
version = "unversioned"
verdict = "fail"
measures = ["separation_error", "consistency_error"]
cause = "defect"
reason = "It gives half the depth."
upstream = "unreported"
expires = 9999-12-31
)");
  const std::string bounds =
      "mine/known half_depth separation_error=0.1 consistency_error=0.1\n";
  Write("data/known_discrepancies.bounds", bounds);
  const auto run = [this](const std::string& what) {
    return InPipe("TOUCHSTONE_TEST_DATA=" + Path("data") + " " +
                  Command("run --fail-on subject --subject half_depth " + what))
        .code;
  };
  EXPECT_EQ(run(""), 0);
  EXPECT_EQ(run("mine/known"), 0);
  EXPECT_EQ(run(Path("data/catalogue/mine/known.toml")), 0);
  Write("data/known_discrepancies.bounds",
        bounds + Replaced(bounds, "mine/known", "mine/deep"));
  // These ids match the entry, but the files are not part of the built-in catalogue.
  EXPECT_EQ(run(Path("mine/deep.toml")), 1);
  EXPECT_EQ(run(Path("mine/deep.toml") + " mine/known"), 1);
  EXPECT_EQ(run("--catalogue " + Path("mine")), 1);
  Write("mine/known.toml",
        Replaced(Replaced(kDeep, "mine/deep", "mine/known"), "0.3, -0.2", "0.3, -0.1"));
  EXPECT_EQ(run(Path("mine/known.toml")), 1);
  // The user's own ledger applies to any file.
  EXPECT_EQ(run("--ledger " + Path("data/known_discrepancies.toml") + " " +
                Path("mine/deep.toml")),
            0);
}

TEST_F(CommandLineTest, ReportsAMissingFile) {
  const Ended ended = Touchstone("run " + Path("nowhere.toml"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("nowhere.toml: cannot be read; expected a"));
}

TEST_F(CommandLineTest, WritesTheSameReportsWhateverTheNumberOfThreads) {
  const auto contents = [this](const std::string& name) {
    return WithoutSeconds(folder_ / name);
  };
  const std::string run = "run --subject half_depth " + Path("mine/deep.toml");
  EXPECT_EQ(Touchstone(run + " --jobs 1 --out " + Path("one")).code, 1);
  EXPECT_EQ(Touchstone(run + " --jobs 4 --out " + Path("four")).code, 1);
  for (const std::string file : {"report.data", "report.jsonl", "junit.xml"}) {
    EXPECT_NE(contents("one/" + file), "");
    EXPECT_EQ(contents("one/" + file), contents("four/" + file)) << file;
  }
}

TEST_F(CommandLineTest, PrintsTheTimingsOnRequest) {
  const std::string run = "run --subject half_depth " + Path("mine/deep.toml");
  EXPECT_THAT(Touchstone(run).out, Not(HasSubstr("the longest")));
  EXPECT_THAT(Touchstone(run + " --timings").out,
              AllOf(HasSubstr("the longest, on the clock\n"),
                    HasSubstr(" s  mine/deep  half_depth\n")));
}

TEST_F(CommandLineTest, ReportsBeforeTheRunThatAReportCannotBeWritten) {
  Write("file", "in the way");
  const auto error = [this](const std::string& line) {
    const Ended ended = Touchstone(line);
    EXPECT_EQ(ended.code, 2) << line;
    EXPECT_EQ(ended.out, "") << line;
    return ended.err;
  };
  const std::string run = "run " + Path("mine/deep.toml") + " --out ";
  EXPECT_THAT(error(run + Path("file")), HasSubstr("cannot create the folder"));
  std::filesystem::create_directories(folder_ / "taken/report.jsonl");
  EXPECT_THAT(error(run + Path("taken")), HasSubstr("cannot write"));
  EXPECT_THAT(error("sweep contact --pair sphere sphere --out " + Path("file")),
              HasSubstr("cannot create the folder"));
}

TEST_F(CommandLineTest, UsesColoursOnATerminalOnly) {
  const std::string run = Command("run " + Path("mine/deep.toml"));
  const auto has_no_colours = AllOf(HasSubstr("mine/deep"), Not(HasSubstr("\x1b[")));
  EXPECT_THAT(InPipe(run).out, has_no_colours);
  if (!CanOpenTerminals()) GTEST_SKIP() << "no pseudo-terminal: is /dev/pts mounted?";
  EXPECT_THAT(OnTerminal("NO_COLOR= TERM=xterm " + run).out, HasSubstr("\x1b["));
  EXPECT_THAT(OnTerminal("NO_COLOR=1 TERM=xterm " + run).out, has_no_colours);
}

TEST_F(CommandLineTest, ExplainsWhichOraclesAreRightAndShowsTheFileOnRequest) {
  const std::string explain = "explain " + Path("mine/deep.toml");
  const Ended ended = Touchstone(explain);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out,
              AllOf(Not(HasSubstr("[bodies.ball]")), HasSubstr("Right: right\n"),
                    HasSubstr("Wrong: half_depth (over 0.001), thrower (unusable)\n")));
  EXPECT_THAT(Touchstone(explain + " --all").out, HasSubstr("[bodies.ball]"));
}

TEST_F(CommandLineTest, ExplainsSeveralScenariosInOneLineEach) {
  Write("mine/other.toml", Replaced(kDeep, "mine/deep", "mine/other"));
  const Ended ended = Touchstone("explain " + Path("mine"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("\nmine/deep   touching"),
                               HasSubstr("\nmine/other  touching"),
                               HasSubstr("touchstone explain ID (or its file)\n"),
                               Not(HasSubstr("[bodies.ball]"))));
}

TEST_F(CommandLineTest, PrintsAQuestionAsAScenarioThatItReads) {
  const std::string ask =
      "ask --A 'sphere 0.5 @ 0.3 -0.2 0.7' --B 'sphere 0.5 @ 0.9 -0.5 1.3' --toml";
  const Ended asked = Touchstone(ask + " --id kept/ball");
  EXPECT_EQ(asked.code, 0) << asked.err;
  EXPECT_THAT(asked.out, HasSubstr("id = \"kept/ball\"\n"));
  std::filesystem::create_directories(folder_ / "kept");
  Write("kept/ball.toml", asked.out);
  const Ended ended = Touchstone("run --fail-on subject " + Path("kept"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 scenario × 4 oracles"));
  EXPECT_THAT(Touchstone(ask + " --id 'My Ball'").err, HasSubstr("id is \"My Ball\""));
}

TEST_F(CommandLineTest, AnswersAQuestionFromTheCommandLine) {
  const Ended ended =
      Touchstone("ask --A 'sphere 0.5 @ 0.3 -0.2 0.7' --B 'sphere 0.5 @ 0.9 -0.5 1.3'");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(
      ended.out,
      HasSubstr("Right: right\nWrong: half_depth (over 0.001), thrower (unusable)\n"));
}

TEST_F(CommandLineTest, AnswersTheQuestionsThatItsHelpShows) {
  std::istringstream lines(Touchstone("ask --help").out);
  const std::string start = "  touchstone ask ";
  int asked = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(start)) continue;
    // Without the redirection, which would leave a file behind.
    line = line.substr(start.size(), line.find(" > ") - start.size());
    EXPECT_EQ(InPipe(TouchstoneProgram() + " ask " + line).code, 0) << line;
    ++asked;
  }
  EXPECT_GT(asked, 0);
}

TEST_F(CommandLineTest, StatesTheErrorInABody) {
  const auto error = [this](const std::string& body) {
    const Ended ended = Touchstone("ask --A 'sphere 1' --B '" + body + "'");
    EXPECT_EQ(ended.code, 2) << body;
    return ended.err;
  };
  EXPECT_THAT(error("sphere 1 q 1"), HasSubstr("1 number after 'q'"));
  EXPECT_THAT(error("box 1 2"), HasSubstr("2 numbers after 'box', which takes three"));
  EXPECT_THAT(error("sphre 1"), HasSubstr("did you mean sphere?"));
  EXPECT_THAT(error("sphere 1 @ 1 2"), HasSubstr("2 numbers after '@'"));
  EXPECT_THAT(error("sphere 1 and more"), HasSubstr("unexpected text at 'and'"));
  EXPECT_THAT(error("sphere 1 q 0 0 0 0"), HasSubstr("zero quaternion"));
  EXPECT_THAT(error("sphere 1e400"), HasSubstr("'1e400', which is beyond the range"));
  EXPECT_THAT(error("sphere -1"), HasSubstr("radius"));
  EXPECT_THAT(error("convex_hull 1 2"), HasSubstr("three per vertex"));
}

TEST_F(CommandLineTest, NormalisesAQuaternionOfAnySize) {
  for (const char* q : {"1e200 1e200 0 0", "1e-200 0 0 0"}) {
    const Ended ended =
        Touchstone(std::string("ask --A 'sphere 1' --B 'sphere 1 @ 0 0 3 q ") + q + "'");
    EXPECT_EQ(ended.code, 0) << ended.err;
  }
}

TEST_F(CommandLineTest, PrintsOnlyFailuresWhenQuiet) {
  const Ended ended = Touchstone("run --quiet " + Path("mine/deep.toml"));
  EXPECT_THAT(ended.out, Not(HasSubstr("worst/tol")));
  EXPECT_THAT(ended.out, HasSubstr("half_depth: fail"));
}

TEST_F(CommandLineTest, ListsTheCapabilitiesAndSettingsOfOracles) {
  const Ended ended = Touchstone("oracles");
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("half_depth"), HasSubstr("user: depth, normal"),
                               HasSubstr("sphere-sphere")));
  EXPECT_THAT(Touchstone("oracles --settings").out, HasSubstr("conventions = "));
}

TEST_F(CommandLineTest, ListsTheWorldFeaturesThatOraclesSimulate) {
  EXPECT_THAT(InPipe(TouchstoneProgram() + " oracles").out,
              HasSubstr("simulates worlds with\n        sphere, box, "));
  // One oracle of this program simulates.
  const std::string simulates = "simulates worlds with";
  const std::string listed = Touchstone("oracles").out;
  EXPECT_THAT(listed, HasSubstr(simulates));
  EXPECT_EQ(listed.find(simulates), listed.rfind(simulates));
}

TEST_F(CommandLineTest, ListsOncePerOracleWhatItDoesNotSupport) {
  std::istringstream lines(InPipe(TouchstoneProgram() + " oracles").out);
  int of_the_cookbook = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line == "    unsupported: the cookbook has recipes for spheres and boxes only") {
      ++of_the_cookbook;
    }
    EXPECT_LE(line.size(), 80u) << line;
  }
  EXPECT_EQ(of_the_cookbook, 2);  // One of "cookbook", one of "printed".
}

TEST_F(CommandLineTest, SweepsWithTheSameQuestionsForTheSameSeed) {
  const std::string sweep =
      "sweep contact --family random --pair sphere sphere --count 50 --quiet --seed ";
  const Ended ended = Touchstone(sweep + "7");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_EQ(Touchstone(sweep + "7 --jobs 3").out, ended.out);
  EXPECT_NE(Touchstone(sweep + "8").out, ended.out);
  std::istringstream lines(ended.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 150U) << line;
}

TEST_F(CommandLineTest, SweepsOverEachPairOfShapesInOneOrder) {
  const Ended ended =
      Itself("sweep contact --subject cookbook --family random --count 2 --quiet");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, testing::ContainsRegex("random +sphere sphere +2"));
  EXPECT_THAT(ended.out, testing::ContainsRegex("random +sphere box +2"));
  EXPECT_THAT(ended.out, testing::ContainsRegex("random +box box +2"));
  EXPECT_THAT(ended.out, testing::Not(HasSubstr("box sphere")));
}

TEST_F(CommandLineTest, WritesFailedQuestionsAsScenariosThatCanBeRun) {
  const Ended ended = Touchstone(
      "sweep contact --subject half_depth --family random --pair sphere sphere --count "
      "20 "
      "--out " +
      Path("failed"));
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out,
              HasSubstr("Repeat with: touchstone sweep contact --family random"));
  EXPECT_EQ(Touchstone("run --subject half_depth " + Path("failed")).code, 1);
  EXPECT_EQ(Touchstone("run --fail-on subject " + Path("failed")).code, 0);
}

TEST_F(CommandLineTest, SweepsSeveralSubjectsAndClustersTheirFailures) {
  const Ended ended = Touchstone(
      "sweep contact --subject all --family random,vertex_face --pair sphere sphere "
      "--count 30");
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(
      ended.out,
      AllOf(HasSubstr("right: 0 failed of 60"), HasSubstr("thrower: 60 failed of 60"),
            HasSubstr("60  answering: threw std::runtime_error: out of spheres."),
            HasSubstr("  half_depth  "), HasSubstr("--first 0 ")));
  EXPECT_THAT(ended.out, Not(HasSubstr("drifter")));
}

TEST_F(CommandLineTest, FailsASweepOnFailuresAboveAGrade) {
  const std::string sweep =
      "sweep contact --family random --pair sphere sphere --count 50 --quiet --subject ";
  EXPECT_EQ(Touchstone(sweep + "half_depth --fail-above 1e-3").code, 1);
  EXPECT_EQ(Touchstone(sweep + "half_depth --fail-above touching").code, 0);
  EXPECT_EQ(Touchstone(sweep + "thrower --fail-above touching").code, 1);
}

TEST_F(CommandLineTest, ResumesASweepAndMergesItsShards) {
  const std::string sweep =
      "sweep contact --family random --pair sphere sphere --count 5000 --quiet --out ";
  EXPECT_EQ(Touchstone(sweep + Path("whole")).code, 0);
  const std::string whole = TextOf(Path("whole/sweep.sqlite"));
  EXPECT_GT(whole.size(), 4096U);
  // The second time it is complete.
  EXPECT_EQ(Touchstone(sweep + Path("whole")).code, 0);
  EXPECT_TRUE(TextOf(Path("whole/sweep.sqlite")) == whole);
  const Ended other = Touchstone(sweep + Path("whole") + " --seed 2");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("belongs to another sweep: seed 1, not 2; expected"));
  for (const char* shard : {"1/2", "2/2"})
    Touchstone(sweep + Path("shards") + " --shard " + shard);
  const std::string parts =
      Path("shards/sweep.1-of-2.sqlite") + " " + Path("shards/sweep.2-of-2.sqlite");
  EXPECT_EQ(Touchstone("merge " + parts + " -o " + Path("merged")).code, 0);
  EXPECT_TRUE(TextOf(Path("merged")) == whole);
  const Ended missing =
      Touchstone("merge " + Path("shards/sweep.1-of-2.sqlite") + " -o " + Path("merged"));
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.err, HasSubstr("block 1 of 20 is missing; expected"));
}

TEST_F(CommandLineTest, SweepsWorldsAndWritesFailedOnesAsScenariosThatCanBeRun) {
  const std::string sweep = "sweep world --subject drifter --count 40 --seed 3 ";
  const Ended ended = Touchstone(sweep + "--family drops,rods --out " + Path("worlds"));
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("drops"), HasSubstr(" failed of 80"),
                    HasSubstr("  touchstone sweep world --family rods --seed 3 --first "),
                    HasSubstr(" (moves_at_its_velocity)")));
  EXPECT_EQ(Touchstone("run --subject drifter --against drifter " +
                       Path("worlds/sweep/world/rods"))
                .code,
            1);
  const Ended all =
      Touchstone("sweep world --subject all --family rods --count 5 --quiet");
  EXPECT_THAT(all.out, AllOf(HasSubstr("drifter: "), Not(HasSubstr("right"))));
}

TEST_F(CommandLineTest, FindsTheRootCausesOfASweep) {
  Touchstone(
      "sweep contact --subject half_depth,thrower,right --family random --pair "
      "sphere sphere --count 30 --quiet --out " +
      Path("night"));
  const Ended ended = Touchstone("triage --no-programs " + Path("night"));
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("2 root causes."), HasSubstr("wrong depth"),
                               HasSubstr("threw std::runtime_error: out of spheres")));
  const std::string index = TextOf(Path("night/triage/index.md"));
  EXPECT_THAT(index, AllOf(HasSubstr("| 1 | ["), HasSubstr("| 2 | ["),
                           HasSubstr("| half_depth |"), Not(HasSubstr("| right"))));
  const Ended one = Touchstone("triage --no-programs --subject thrower --out " +
                               Path("one") + " " + Path("night"));
  EXPECT_EQ(one.code, 1) << one.err;
  EXPECT_THAT(one.out, HasSubstr("1 root cause. They have 30 of 30 failures."));
  const Ended unasked =
      Touchstone("triage --subject drifter --out " + Path("two") + " " + Path("night"));
  EXPECT_EQ(unasked.code, 2);
  EXPECT_THAT(unasked.err,
              HasSubstr("was not asked; expected one of half_depth, thrower, right"));
  // The same again is nothing new.
  const Ended again = Touchstone("triage --no-programs " + Path("night") + " --out " +
                                 Path("again") + " --baseline " + Path("night/triage"));
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("2 root causes, 0 of them new since the baseline."));
  EXPECT_EQ(TextOf(Path("again/roots.txt")), TextOf(Path("night/triage/roots.txt")));

  // The sweep's failures, and the cases of the triage beside them.
  for (const char* const folder : {"night", "night/triage"}) {
    EXPECT_EQ(Touchstone("run --subject half_depth " + Path(folder)).code, 1);
  }

  const Ended over = Touchstone("triage --no-programs " + Path("night"));
  EXPECT_EQ(over.code, 2);
  EXPECT_THAT(over.err, HasSubstr("holds an earlier triage; expected"));
  const Ended none = Touchstone("triage " + Path("nothing"));
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("nothing"));
  EXPECT_EQ(Touchstone("triage " + Path("night") + " --baseline " + Path("nothing")).code,
            2);
}

// The spheres are 0.1 m deep in each other, and half_depth says half of it.
TEST_F(CommandLineTest, ShrinksAFaultWhileItStaysOverANumber) {
  const std::string shrink = "shrink " + Path("mine/deep.toml") + " --for half_depth ";
  const Ended ended = Touchstone(shrink + "--keep 'separation_error > 0.04'");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("--keep 'separation_error >"));
  const Ended large = Touchstone(shrink + "--keep 'separation_error > 0.06'");
  EXPECT_EQ(large.code, 2);
  EXPECT_THAT(large.err, HasSubstr("in separation_error by more than 0.06"));
  for (const char* const keep : {"", "0.1", "separation_error", "separation_error > deep",
                                 "> 0.1", "separation_error > -1"}) {
    const Ended refused = Touchstone(shrink + "--keep '" + keep + "'");
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("cannot be read; expected a measure and a number"))
        << keep;
  }
  EXPECT_THAT(Touchstone(shrink + "--keep 'excess > 0' --measure excess").code, 2);
}

TEST_F(CommandLineTest, NamesThoseWhoAreWrongWhereTheChosenOracleIsRight) {
  const Ended ended = Touchstone("shrink " + Path("mine/deep.toml") + " --for right");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("no answer of right is proved wrong in mine/deep"));
  EXPECT_THAT(ended.err, HasSubstr("; expected one of those who are wrong: half_depth"));
}

TEST_F(CommandLineTest, FindsTheRootCausesOfARun) {
  const std::string deep = Path("mine/deep.toml");
  Touchstone("run --subject half_depth --against right " + deep + " --quiet --out " +
             Path("run"));
  const Ended ended = Touchstone("triage --no-programs " + Path("run"));
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("1 root cause. They have 1 of 1 failures."),
                               HasSubstr("100 %"), HasSubstr("wrong depth")));
  const Ended none = Touchstone("triage --no-programs --subject right --out " +
                                Path("none") + " " + Path("run"));
  EXPECT_EQ(none.code, 0) << none.err;
  EXPECT_THAT(none.out, HasSubstr("0 root causes."));
  const Ended neither = Touchstone("triage " + Path("mine"));
  EXPECT_EQ(neither.code, 2);
  EXPECT_THAT(neither.err, HasSubstr("has neither sweep.sqlite nor report.data"));
}

TEST_F(CommandLineTest, SaysThatASweepToTriageIsNotFinished) {
  Touchstone(
      "sweep contact --subject half_depth --family random --pair sphere sphere --count "
      "10000000 --time 1s --quiet --out " +
      Path("begun"));
  const Ended ended = Touchstone("triage " + Path("begun"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("its sweep is not finished; expected the same"));
}

TEST_F(CommandLineTest, WritesThePageOfASweepOfWorlds) {
  Touchstone("sweep world --subject drifter --family rods --count 20 --quiet --out " +
             Path("worlds"));
  const Ended ended =
      Touchstone("report " + Path("worlds/sweep.sqlite") + " -o " + Path("page.html"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(TextOf(Path("page.html")), HasSubstr("id=\"report-data\">"));
}

TEST_F(CommandLineTest, TakesTheIdOfAQuestionOfASweepWithoutItsFile) {
  const Ended contact =
      Touchstone("explain sweep/random/sphere_sphere/seed_7/0000000000000000042 --all");
  EXPECT_EQ(contact.code, 0) << contact.err;
  EXPECT_THAT(contact.out, HasSubstr("touchstone sweep contact --family random --pair "
                                     "sphere sphere --seed 7 --first 42 --count 1"));
  EXPECT_EQ(Touchstone("simulate sweep/world/rods/seed_3/0 --oracles drifter --csv " +
                       Path("motion.csv"))
                .code,
            0);
  EXPECT_THAT(TextOf(Path("motion.csv")), HasSubstr("drifter"));
  // The ledger is about the catalogue.
  EXPECT_EQ(
      Touchstone("run sweep/world/rods/seed_3/0 --subject drifter --against drifter")
          .code,
      1);
  const Ended missing = Touchstone("explain sweep/random/sphere_sphere/7/42");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.err, HasSubstr("no question of a sweep has the id"));
}

TEST_F(CommandLineTest, ResumesASweepOfWorldsAndMergesItsShards) {
  const std::string sweep =
      "sweep world --subject drifter --family drops --count 100 --quiet --out ";
  Touchstone(sweep + Path("whole"));
  const std::string whole = TextOf(Path("whole/sweep.sqlite"));
  EXPECT_GT(whole.size(), 4096U);
  for (const char* shard : {"1/2", "2/2"})
    Touchstone(sweep + Path("shards") + " --jobs 2 --shard " + shard);
  const std::string parts =
      Path("shards/sweep.1-of-2.sqlite") + " " + Path("shards/sweep.2-of-2.sqlite");
  EXPECT_EQ(Touchstone("merge " + parts + " -o " + Path("merged")).code, 0);
  EXPECT_TRUE(TextOf(Path("merged")) == whole);
  // The settings of an engine are part of a sweep.
  const Ended other = Touchstone(sweep + Path("whole") + " --set drifter:drift=1");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("belongs to another sweep: subjects"));
}

TEST_F(CommandLineTest, RefusesASweepOfWorldsWithOptionsOfContactQuestions) {
  const auto error_of = [this](const std::string& options) {
    const Ended ended = Touchstone("sweep world --count 5 " + options);
    EXPECT_EQ(ended.code, 2) << options;
    return ended.err;
  };
  EXPECT_THAT(error_of("--pair box box"), HasSubstr("--pair is for contact questions"));
  EXPECT_THAT(error_of("--climb 8"), HasSubstr("--climb is for contact questions"));
  EXPECT_THAT(error_of("--family stack"),
              HasSubstr("no family 'stack' (did you mean stacks?)"));
  EXPECT_THAT(error_of("--family grazing"), HasSubstr("expected one of: all, drops"));
  // "right" simulates nothing.
  EXPECT_THAT(error_of("--subject right"),
              HasSubstr("nothing was verified; expected a world that right simulates"));
}

// The subject needs minutes for these questions, so the signal comes before the end.
TEST_F(CommandLineTest, SaysWhichAnswersFailedInTheFilesOfASweep) {
  const Ended ended = Touchstone(
      "sweep contact --family random --pair sphere sphere --count 20 "
      "--subject half_depth --out " +
      Path("failed"));
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(" as files: " + Path("failed/sweep")));
  std::string text;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(Path("failed/sweep"))) {
    if (text.empty() && entry.is_regular_file()) text = TextOf(entry.path());
  }
  EXPECT_THAT(text, testing::StartsWith("# half_depth fails separation_error: "));
  EXPECT_THAT(text, HasSubstr("half_depth says"));
}

// A climb depends on the oracle, so that two oracles have two questions of one id.
TEST_F(CommandLineTest, WritesTheQuestionsOfAClimbForEachOracle) {
  Touchstone(
      "sweep contact --family random --pair sphere sphere --count 64 --climb 8 "
      "--subject half_depth,right --quiet --out " +
      Path("climb"));
  std::size_t files = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(Path("climb/sweep"))) {
    if (!entry.is_regular_file()) continue;
    ++files;
    EXPECT_EQ(entry.path().filename(), "half_depth.toml");
  }
  EXPECT_GT(files, 0u);
  const Ended again = Touchstone("run --subject half_depth --quiet " + Path("climb"));
  EXPECT_EQ(again.code, 1) << again.err;
}

TEST_F(CommandLineTest, SaysThatAnOptionIsIncompleteIfItTakesAnotherAsItsValue) {
  const Ended ended = Touchstone("sweep contact --pair box --count 5");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("--pair is incomplete; expected --pair SHAPE SHAPE"));
}

TEST_F(CommandLineTest, SaysThatAnOptionIsGivenMoreThanOnce) {
  EXPECT_THAT(Touchstone("run --out a --out b").err,
              HasSubstr("--out is given more than once; expected it once"));
  EXPECT_THAT(Touchstone("run --out").err, HasSubstr("--out is incomplete"));
}

TEST_F(CommandLineTest, SaysThatAShardDoesNotExist) {
  const Ended ended = Touchstone("merge -o merged.sqlite " + Path("none.sqlite"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("none.sqlite: does not exist; expected a file that "
                                   "`touchstone sweep --out DIR` wrote"));
}

TEST_F(CommandLineTest, EndsASweepCleanlyAtCtrlC) {
  // timeout sends its signal to the program and again to its group.
  const std::string sweep =
      "sweep contact --family random --pair sphere sphere "
      "--count 1000000000 --quiet --out " +
      Path("stopped");
  const Ended ended = InPipe("timeout --signal=INT 2 " + Command(sweep));
  EXPECT_THAT(ended.err, HasSubstr("the same command goes on from there"));
  EXPECT_THAT(TextOf(Path("stopped/sweep.unfinished.sqlite")), HasSubstr("SQLite"));
  const Ended timed = Touchstone(sweep + " --time 1s");
  EXPECT_EQ(timed.code, 0) << timed.err;
  EXPECT_THAT(timed.err, HasSubstr("the same command goes on from there"));
}

/** Returns a table of two unit balls that sink into each other by `step` a row. */
std::string TableOfBalls(int rows, double step) {
  std::ostringstream text;
  text << "A.shape,A.radius,B.shape,B.radius,B.position.x,B.position.y,B.position.z\n";
  for (int row = 0; row < rows; ++row)
    text << "sphere,1,sphere,1," << 1.9 - step * row << ",0.1,0\n";
  return text.str();
}

TEST_F(CommandLineTest, SweepsTheQuestionsOfATable) {
  const Ended ended = Itself("sweep contact --quiet --subject cookbook --from " +
                             InSourceTree("docs/examples/poses.csv").string());
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("docs/examples/poses.csv  box box "),
                    HasSubstr("docs/examples/poses.csv  box half_space "),
                    HasSubstr("cookbook: 0 failed of 5; 3 more not supported")));
}

TEST_F(CommandLineTest, KeepsAndRepeatsTheFailedQuestionsOfATable) {
  Write("my balls.csv", TableOfBalls(5, 0.01));
  const Ended ended = Touchstone("sweep contact --subject half_depth --from '" +
                                 Path("my balls.csv") + "' --out " + Path("failed"));
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("half_depth: 5 failed of 5"),
                               HasSubstr("2 failed questions as files")));
  const std::string repeat = "Repeat with: touchstone ";
  const std::size_t at = ended.out.find(repeat);
  ASSERT_NE(at, std::string::npos) << ended.out;
  const std::size_t begin = at + repeat.size();
  const Ended repeated =
      Touchstone(ended.out.substr(begin, ended.out.find('\n', begin) - begin));
  EXPECT_EQ(repeated.code, 1) << repeated.err;
  EXPECT_THAT(repeated.out, HasSubstr("half_depth: 1 failed of 1"));
  // The kept questions can be run, and swept again.
  EXPECT_EQ(Touchstone("run --subject half_depth " + Path("failed/sweep")).code, 1);
  EXPECT_THAT(Touchstone("sweep contact --subject half_depth --quiet --from " +
                         Path("failed/sweep"))
                  .out,
              HasSubstr("half_depth: 2 failed of 2"));
  const Ended triage = Touchstone("triage --no-programs " + Path("failed"));
  EXPECT_EQ(triage.code, 1) << triage.err;
  EXPECT_THAT(triage.out, HasSubstr("1 root cause"));
  int reports = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(Path("failed/triage"))) {
    if (entry.path().filename() != "REPORT.md") continue;
    EXPECT_THAT(TextOf(entry.path()),
                HasSubstr("my balls.csv, sphere and sphere | 5 of 5"));
    ++reports;
  }
  EXPECT_EQ(reports, 1);
  EXPECT_EQ(Touchstone("report " + Path("failed") + " -o " + Path("page.html")).code, 0);
}

/** Sweeps, and kills the program once the file of its results is there. */
constexpr const char* kKilledSweep = R"sh(sh -c '
"$0" sweep contact --subject half_depth --quiet --from "$1" --out "$2" &
while [ ! -f "$2/sweep.unfinished.sqlite" ]
do kill -0 $! 2>/dev/null || exit 9; sleep 0.01; done
kill -KILL $!; wait $!' )sh";

TEST_F(CommandLineTest, ResumesASweepOfATableAndMergesItsShards) {
  Write("balls.csv", TableOfBalls(40'000, 1e-5));
  const std::string sweep = "sweep contact --subject half_depth --quiet --from " +
                            Path("balls.csv") + " --out ";
  EXPECT_EQ(Touchstone(sweep + Path("whole") + " --jobs 1").code, 1);
  const std::string whole = TextOf(Path("whole/sweep.sqlite"));
  const Ended killed = InPipe(kKilledSweep + ProgramWithFaults() + " " +
                              Path("balls.csv") + " " + Path("killed"));
  EXPECT_EQ(killed.code, 137) << killed.err;
  EXPECT_FALSE(std::filesystem::exists(Path("killed/sweep.sqlite")));
  Touchstone(sweep + Path("killed") + " --time 1s");
  EXPECT_EQ(Touchstone(sweep + Path("killed") + " --jobs 3").code, 1);
  EXPECT_TRUE(TextOf(Path("killed/sweep.sqlite")) == whole);
  for (const char* shard : {"1/2", "2/2"})
    Touchstone(sweep + Path("shards") + " --shard " + shard);
  const std::string first = Path("shards/sweep.1-of-2.sqlite");
  const std::string second = Path("shards/sweep.2-of-2.sqlite");
  EXPECT_EQ(Touchstone("merge " + first + " " + second + " -o " + Path("merged")).code,
            0);
  EXPECT_TRUE(TextOf(Path("merged")) == whole);

  Write("balls.csv", TableOfBalls(40'000, 1.1e-5));
  const Ended other = Touchstone(sweep + Path("whole"));
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("belongs to another sweep: questions in " +
                                   Path("balls.csv") + " with digest "));
  Touchstone(sweep + Path("others") + " --shard 2/2");
  const Ended mixed = Touchstone(
      "merge " + first + " " + Path("others/sweep.2-of-2.sqlite") + " -o " + Path("no"));
  EXPECT_EQ(mixed.code, 2);
  EXPECT_THAT(mixed.err, HasSubstr("it has questions in " + Path("balls.csv")));
}

TEST_F(CommandLineTest, ChoosesQuestionsOfATable) {
  Write("mixed.csv",
        "A.shape,A.radius,B.shape,B.radius,B.position.x,B.position.y,B.position.z\n"
        "sphere,1,sphere,1,1.9,0,0\nsphere,1,half_space,,0,0,0\n"
        "sphere,1,sphere,1,2.5,0,0\nsphere,1,sphere,1,1.8,0,0\n");
  const auto output_of = [&](const std::string& options) {
    const Ended ended = Touchstone("sweep contact --subject right --quiet --from " +
                                   Path("mixed.csv") + " " + options);
    return ended.out + ended.err;
  };
  EXPECT_THAT(output_of(""), HasSubstr("right: 0 failed of 3"));
  EXPECT_THAT(output_of("--count 2"), HasSubstr("right: 0 failed of 2"));
  EXPECT_THAT(output_of("--pair sphere sphere --first 1"),
              AllOf(HasSubstr("right: 0 failed of 2"), Not(HasSubstr("half_space"))));
  // Poses that are all apart verify something.
  EXPECT_THAT(output_of("--pair sphere sphere --first 1 --count 1"),
              Not(HasSubstr("nothing was verified")));
  EXPECT_THAT(output_of("--pair sphere half_space"),
              HasSubstr("nothing was verified; expected a question that right supports"));
  EXPECT_THAT(output_of("--pair box box"),
              HasSubstr("mixed.csv: has no question that --pair and --first choose; "
                        "expected some of its: 3 of sphere sphere, 1 of sphere "
                        "half_space"));
  EXPECT_THAT(output_of("--first 3"), HasSubstr("has no question that"));
}

TEST_F(CommandLineTest, RefusesTheQuestionsOfABadFileAndOptionsOfGeneratedOnes) {
  const auto error_of = [&](const std::string& arguments) {
    const Ended ended = Touchstone("sweep " + arguments);
    EXPECT_EQ(ended.code, 2) << arguments;
    return ended.err;
  };
  Write("bad.csv", "A.shape,A.radius,B.shape\nsphere,inf,half_space\n");
  EXPECT_EQ(error_of("contact --from " + Path("bad.csv")),
            "touchstone: " + Path("bad.csv") +
                ":2:8: A.radius is \"inf\"; expected a finite number, without spaces\n");
  EXPECT_THAT(error_of("contact --from " + Path("none.toml")),
              HasSubstr("cannot be read"));
  const std::string from = "contact --from " + Path("mine/deep.toml");
  for (const char* option : {"--family random", "--seed 1", "--climb 8"}) {
    EXPECT_THAT(error_of(from + " " + option),
                HasSubstr(" is for generated questions; expected no such option with "
                          "--from"));
  }
  EXPECT_THAT(error_of("world --from " + Path("mine/deep.toml")),
              HasSubstr("--from is for contact questions; expected no such option"));
}

TEST_F(CommandLineTest, RefusesSlurmWithoutItsCommandsAFolderOrWithOtherParts) {
  const std::string sweep = "sweep contact --pair sphere sphere --count 1000 ";
  const auto error_of = [&](const std::string& options) {
    const Ended ended = Touchstone(sweep + options);
    EXPECT_EQ(ended.code, 2) << options;
    return ended.err;
  };
  EXPECT_THAT(error_of("--slurm"), HasSubstr("expected --out DIR"));
  EXPECT_THAT(error_of("--tasks 4"), HasSubstr("belong to --slurm"));
  const std::string slurm = "--slurm --out " + Path("cluster");
  EXPECT_THAT(error_of(slurm + " --shard 1/2"), HasSubstr("expected --tasks"));
  EXPECT_THAT(error_of(slurm + " --time 1h"), HasSubstr("expected --sbatch-args"));
  EXPECT_THAT(error_of(slurm + " --status"), HasSubstr("no sweep was submitted"));
  const Ended without = InPipe("PATH=/nowhere " + Command(sweep + slurm));
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("there is no sbatch; expected"));
}

TEST_F(CommandLineTest, ReproducesTheGravestFindingThatAProgramCanCheck) {
  // The gravest is a jump of the answer, which a single query cannot show.
  const std::string question =
      "reproduce contact/zoo/ccd_71b --for libccd/mpr --out " + Path("program");
  const Ended other = Itself(question);
  EXPECT_EQ(other.code, 0) << other.err;
  EXPECT_THAT(other.out, HasSubstr(" in separation_error, "));
  const Ended named = Itself(question + " --measure perturbation");
  EXPECT_EQ(named.code, 2);
  EXPECT_THAT(named.err, HasSubstr("cannot be reproduced"));
  EXPECT_THAT(named.err, HasSubstr("mixed_normals; choose one that the answer fails with "
                                   "--measure"));
}

TEST_F(CommandLineTest, SubmitsToSlurmOnceAndOnlyTheSweepOfTheFolder) {
  // A cluster that takes every job and never starts it.
  std::filesystem::create_directory(Path("bin"));
  Write("bin/sbatch", "#!/bin/sh\necho 7\n");
  Write("bin/squeue", "#!/bin/sh\necho 7 1 PENDING\necho 7 2 PENDING\n");
  for (const char* const command : {"bin/sbatch", "bin/squeue"}) {
    std::filesystem::permissions(Path(command), std::filesystem::perms::owner_all);
  }
  const auto sweep = [&](const std::string& options) {
    return InPipe("PATH=" + Path("bin") + ":$PATH " +
                  Command("sweep contact --family random --pair sphere sphere --slurm "
                          "--out " +
                          Path("cluster") + " " + options));
  };
  EXPECT_THAT(sweep("--count 200").err, HasSubstr("one block of at most 256 questions"));
  EXPECT_THAT(sweep("--count 600 --tasks 9").err, HasSubstr("expected 2 to 3"));
  for (const char* const option :
       {"--array=1-2", "--clu=x", "-Mx", "-d", "--test-only"}) {
    EXPECT_THAT(sweep(std::string("--count 600 --sbatch-args=") + option).err,
                HasSubstr("is set by the sweep itself"))
        << option;
  }
  const Ended first = sweep("--count 600 --tasks 2");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("shards 1-2 of 2: job 7\n"));
  // Both shards are in the queue now, and the merge is not.
  const Ended again = sweep("--count 600");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.out, AllOf(HasSubstr("merge into "), Not(HasSubstr("shards"))));
  EXPECT_THAT(sweep("--count 600 --tasks 3").err, HasSubstr("with --tasks 2"));
  const Ended status = sweep("--count 600 --status");
  EXPECT_EQ(status.code, 1) << status.err;
  EXPECT_THAT(status.out, HasSubstr("shard    1 of 2  PENDING\n"));
  for (const char* const other :
       {"--count 600 --seed 5", "--count 600 --seed 5 --status"}) {
    const Ended refused = sweep(other);
    EXPECT_EQ(refused.code, 2) << other;
    EXPECT_THAT(refused.err, HasSubstr("seed 1, not 5"));
  }
}

TEST_F(CommandLineTest, FailsASweepInWhichNothingTouched) {
  EXPECT_EQ(Touchstone("sweep contact --pair box box --count 10").code, 2);
}

TEST_F(CommandLineTest, ShowsTimeAndAccuracyOfContactQueries) {
  const Ended ended =
      Touchstone("bench contact --pair sphere sphere --count 100 --sample 100");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("ns/query"), HasSubstr("half_depth")));
}

TEST_F(CommandLineTest, StatesTheErrorInACommandLineInOneSentence) {
  const auto error = [this](const std::string& line) {
    const Ended ended = Touchstone(line);
    EXPECT_EQ(ended.code, 2) << line;
    EXPECT_EQ(ended.out, "") << line;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    return ended.err;
  };
  EXPECT_THAT(error(""), HasSubstr("a command is missing; expected one of: run, "));
  EXPECT_THAT(error("jump"),
              HasSubstr("there is no command 'jump'; expected one of: run, "));
  EXPECT_THAT(error("rnu"), HasSubstr("no command 'rnu' (did you mean run?)"));
  EXPECT_THAT(error("--vrsion"), HasSubstr("--vrsion (did you mean --version?)"));
  EXPECT_THAT(
      error("run --sujbect right"),
      HasSubstr("no option --sujbect (did you mean --subject?); expected one of: "));
  EXPECT_THAT(error("run --sujbect=right"), HasSubstr("(did you mean --subject?)"));
  EXPECT_THAT(error("--quiet run"), HasSubstr("expected `touchstone run --quiet`"));
  EXPECT_THAT(error("oracles here"), HasSubstr("'here' is not expected"));
  EXPECT_THAT(error("ask --A 'sphere 1'"), HasSubstr("--B is missing: second body"));
  EXPECT_THAT(error("run --out"), HasSubstr("expected --out DIR"));
  EXPECT_THAT(error("sweep contact --pair box"), HasSubstr("--pair SHAPE SHAPE"));
}

TEST_F(CommandLineTest, AcceptsAtMostAsManyThreadsAsProcessors) {
  const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  for (const std::string& threads :
       {std::string("0"), std::string("-1"), std::string("1.5"), std::string("two"),
        std::to_string(processors + 1), std::string("99999999999999999999")}) {
    const Ended ended = Touchstone("bench worlds --threads " + threads);
    EXPECT_EQ(ended.code, 2) << threads;
    EXPECT_EQ(ended.out, "") << threads;
    EXPECT_EQ(ended.err, "touchstone: --threads: '" + threads +
                             "'; expected a whole number from 1 to " +
                             std::to_string(processors) +
                             ", the number of processors; `touchstone bench --help` "
                             "shows its usage\n");
  }
}

TEST_F(CommandLineTest, StatesTheValueThatAnOptionExpects) {
  const auto error = [this](const std::string& line) {
    const Ended ended = Touchstone(line);
    EXPECT_EQ(ended.code, 2) << line;
    EXPECT_EQ(ended.out, "") << line;
    return ended.err;
  };
  EXPECT_THAT(error("run --jobs x"),
              HasSubstr("--jobs: 'x'; expected a whole number of at least 1"));
  EXPECT_THAT(error("run --jobs 0"),
              HasSubstr("'0'; expected a whole number of at least 1"));
  EXPECT_THAT(error("run --jobs 3000000000"), HasSubstr("expected at most 2147483647"));
  EXPECT_THAT(error("sweep contact --seed -1"), HasSubstr("--seed: '-1'; expected"));
  EXPECT_THAT(error("sweep contact --seed 99999999999999999999"),
              HasSubstr("expected at most 18446744073709551615"));
  EXPECT_THAT(error("run --fail-on cookbook"),
              HasSubstr("--fail-on: 'cookbook'; expected subject or faults or anything"));
  EXPECT_THAT(error("sweep contct"), HasSubstr("(did you mean contact?)"));
  EXPECT_THAT(error("sweep contact --shard 3/2"), HasSubstr("expected K/N with 1 <= K"));
  EXPECT_THAT(error("sweep contact --time 10"), HasSubstr("'10'; expected a duration"));
  EXPECT_THAT(error("sweep contact --subject right,rigth"),
              HasSubstr("there is no oracle"));
  EXPECT_THAT(error("sweep contact --family rnadom"),
              HasSubstr("no family 'rnadom' (did you mean random?)"));
  EXPECT_THAT(error("sweep contact --pair box bxo"),
              HasSubstr("--pair: 'bxo' (did you mean box?)"));
}

// A ball dropped from 2 m.
constexpr const char* kDrop = R"(id = "mine/drop"
title = "A ball falls"
source = "Galilei"

[world]
gravity = [0, -9.81, 0]
dt = 0.01
duration = 0.5
sample_every = 10

[bodies.ball]
shape = "sphere"
radius = 0.5
position = [0, 2, 0]
mass = 2

[[claims]]
law = "ballistic"
because = "x = x0 + v0 t + g t^2/2"
)";

TEST_F(CommandLineTest, RunsAWorldOfTheUsersOwn) {
  Write("mine/drop.toml", kDrop);
  const Ended ended = Itself("run --against bullet " + Path("mine/drop.toml"));
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 scenario × 3 oracles: 2 pass, 0 fail"));
}

TEST_F(CommandLineTest, AWorldWithoutAClaimGetsAVerdict) {
  const std::string whole = kDrop;
  const std::string drop = whole.substr(0, whole.find("[[claims]]"));
  Write("mine/drop.toml", drop);
  const Ended ended = Itself("run --against bullet " + Path("mine/drop.toml"));
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("2 pass, 0 fail"));
  EXPECT_THAT(ended.out, HasSubstr("Measured: drifts and depths"));
  const Ended told = Itself("explain " + Path("mine/drop.toml"));
  EXPECT_THAT(told.out, HasSubstr("laws: of every motion "));
}

TEST_F(CommandLineTest, AnExpectationOfTheUsersOwnIsJudged) {
  // It falls from 2 m for 0.5 s: 9.81/8 = 1.22625 m, and half a step less or more.
  for (const bool right : {true, false}) {
    Write("mine/drop.toml",
          std::string(kDrop) +
              "\n[[expect]]\nbody = \"ball\"\nat = 0.5\ntolerance = 0.03\nposition = " +
              (right ? "[0, 0.77375, 0]\n" : "[0, 0.7, 0]\n"));
    const Ended ended = Itself("run --against bullet " + Path("mine/drop.toml"));
    EXPECT_EQ(ended.code, right ? 0 : 1) << ended.out << ended.err;
    if (right) continue;
    EXPECT_THAT(ended.out, HasSubstr("expect[0]: “ball” is expected a position of"));
  }
}

TEST_F(CommandLineTest, SaysThatAFaultIsThatOfASettingAndWhichDefaultCuresIt) {
  Write("mine/drop.toml", kDrop);
  const std::string file = " --subject drifter --against right " + Path("mine/drop.toml");
  const Ended ended = Touchstone("run" + file);
  EXPECT_EQ(ended.code, 1) << ended.out << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("As set here only: "),
                               HasSubstr("the default drift = 0, 0.5 here, is enough")));
  EXPECT_THAT(Touchstone("explain" + file).out,
              AllOf(HasSubstr("Wrong: drifter (over 10 %, as set here only)"),
                    HasSubstr("fail, as set here only")));
  ASSERT_EQ(Touchstone("run --out " + Path("out") + file).code, 1);
  const auto text = [this](const std::string& name) {
    std::ostringstream read;
    read << std::ifstream(Path("out/" + name)).rdbuf();
    return read.str();
  };
  EXPECT_THAT(text("report.jsonl"), HasSubstr(R"("shipped":"as set here only")"));
  EXPECT_THAT(text("junit.xml"), HasSubstr("As set here only: "));
}

TEST_F(CommandLineTest, JudgesEnginesAsShippedOrWithChosenSettingsAndSaysSo) {
  Write("mine/drop.toml", kDrop);
  const std::string file = " --subject drifter --against right " + Path("mine/drop.toml");
  const Ended shipped = Touchstone("run --as-shipped" + file);
  EXPECT_EQ(shipped.code, 0) << shipped.out << shipped.err;
  EXPECT_THAT(shipped.out, HasSubstr("Worlds of drifter: as shipped"));
  EXPECT_EQ(Touchstone("run --set drifter:drift=0" + file).code, 0);
  const Ended chosen = Touchstone("run --as-shipped --set drifter:drift=1" + file);
  EXPECT_EQ(chosen.code, 1);
  EXPECT_THAT(chosen.out, HasSubstr("Worlds of drifter: as shipped, drift = 1 (0.5 as "
                                    "set here, 0 as shipped)"));
  EXPECT_THAT(Touchstone("explain --set drifter:drift=1" + file).out,
              HasSubstr("Worlds of drifter: drift = 1"));
  const std::string simulate = "simulate --oracle drifter " + Path("mine/drop.toml");
  EXPECT_THAT(Touchstone(simulate).out, HasSubstr("drifter,0.5,ball,0.25,"));
  EXPECT_THAT(Touchstone(simulate + " --as-shipped").out,
              HasSubstr("drifter,0.5,ball,0,"));
  EXPECT_THAT(Touchstone(simulate + " --set drifter:drift=2").out,
              HasSubstr("drifter,0.5,ball,1,"));
  EXPECT_THAT(Touchstone("oracles --settings").out,
              HasSubstr("--set drifter:drift=0.5  0 as shipped: drift along x in m/s. To "
                        "have a fault."));
}

TEST_F(CommandLineTest, RefusesASettingThatIsUnknownOrOutOfRange) {
  Write("mine/drop.toml", kDrop);
  const auto error = [this](const std::string& choice) {
    const Ended ended = Touchstone("run --set " + choice + " " + Path("mine/drop.toml"));
    EXPECT_EQ(ended.code, 2) << choice;
    EXPECT_EQ(ended.out, "") << choice;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    return ended.err;
  };
  EXPECT_THAT(error("drfter:drift=1"),
              HasSubstr("no oracle 'drfter' (did you mean drifter?)"));
  EXPECT_THAT(error("drifter:drit=1"),
              HasSubstr("drifter has no setting 'drit' (did you mean drift?)"));
  EXPECT_THAT(error("right:drift=1"), HasSubstr("right has no settings to choose"));
  for (const char* value : {"10", "-1", "nan", "1x", ""}) {
    EXPECT_THAT(error(std::string("drifter:drift=") + value),
                HasSubstr(std::string("--set drifter:drift=") + value +
                          " is refused; expected a number from 0 to 9"));
  }
  for (const char* choice : {"drifter", "drifter=1", "drift=1"})
    EXPECT_THAT(error(choice), HasSubstr("expected ORACLE:NAME=VALUE"));
}

TEST_F(CommandLineTest, RunsNothingIfALawIsUnknown) {
  Write("mine/drop.toml", Replaced(kDrop, "ballistic", "balistic"));
  const Ended ended = Itself("run " + Path("mine/drop.toml"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, HasSubstr(Path("mine/drop.toml") +
                                   ":18:7: claims[0].law is \"balistic\", which is not "
                                   "a law; expected \"ballistic\"\n"));
}

TEST_F(CommandLineTest, RunsNothingIfANumberOfAClaimIsUnknownOrWrong) {
  const std::string claim = R"([[claims]]
law = "conserves_energy"
about = ["ball"]
numbers = { expected_energy = )";
  Write("mine/drop.toml", kDrop + claim + "39.24 }\n");
  EXPECT_EQ(Itself("run --against bullet " + Path("mine/drop.toml")).code, 0);
  const auto error = [&](const std::string& file) {
    Write("mine/drop.toml", file);
    const Ended ended = Itself("run " + Path("mine/drop.toml"));
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.out, "");
    return ended.err;
  };
  EXPECT_THAT(error(Replaced(kDrop + claim + "39.24 }\n", "expected_e", "expected_ki_e")),
              HasSubstr("drop.toml:23:13: unknown key \"expected_ki_energy\" in "
                        "claims[1].numbers; expected \"expected_energy\"\n"));
  EXPECT_THAT(error(kDrop + claim + "39 }\n"),
              HasSubstr("drop.toml:23:31: claims[1].numbers.expected_energy is 39 "
                        "(conserves_energy); expected 39.24, which"));
}

// Returns the contents of the fenced TOML blocks of a page, in order.
std::vector<std::string> FencedToml(const std::string& page) {
  const std::string fence = "```toml\n";
  std::vector<std::string> blocks;
  for (std::size_t at = 0; (at = page.find(fence, at)) != std::string::npos;) {
    at += fence.size();
    blocks.push_back(page.substr(at, page.find("```", at) - at));
  }
  return blocks;
}

TEST_F(CommandLineTest, RunsTheFilesThatTheDescriptionOfTheFormatShows) {
  const std::vector<std::string> blocks =
      FencedToml(TextOf(InSourceTree("docs/scenario_format.md")));
  ASSERT_EQ(blocks.size(), 4U);
  std::filesystem::create_directories(folder_ / "shown/mine");
  Write("shown/mine/ball_on_tilted_box.toml", blocks[0]);
  // The expectations that it shows are about the sliding box.
  Write("shown/mine/box_slides.toml", blocks[1] + blocks[2]);
  Write("ledger.toml", blocks[3]);
  const Ended ended = Itself("run --fail-on subject --ledger " + Path("ledger.toml") +
                             " " + Path("shown"));
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("cookbook never failed (it answers "));
}

TEST_F(CommandLineTest, RunsTheScenarioThatTheUserGuideShows) {
  const std::string guide = TextOf(InSourceTree("docs/using.md"));
  std::istringstream lines(guide.substr(guide.find("    id = \"mine/ball_on_post\"")));
  std::string file;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && !line.starts_with("    ")) break;
    if (line.starts_with("    touchstone")) break;
    file += line.substr(std::min<std::size_t>(line.size(), 4)) + "\n";
  }
  Write("mine/ball_on_post.toml", file);
  const Ended ended = Itself("run --fail-on subject " + Path("mine/ball_on_post.toml"));
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err << file;
}

TEST_F(CommandLineTest, SimulatesWorldsIntoATable) {
  Write("mine/drop.toml", kDrop);
  const Ended ended =
      Itself("simulate " + Path("mine/drop.toml") + " --oracle cookbook,bullet");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("\nmine/drop,cookbook,0.1,ball,0,1.9"));
  EXPECT_THAT(ended.out, HasSubstr("\nmine/drop,bullet,0.5,ball,0,0."));
  EXPECT_THAT(ended.out, HasSubstr("\nmine/drop,cookbook/sleeping,0.5,ball,0,0."));
  EXPECT_EQ(std::count(ended.out.begin(), ended.out.end(), '\n'), 1 + 3 * 6);
}

TEST_F(CommandLineTest, AsksAProgramLikeAnyOtherOracle) {
  const std::string program =
      " --oracle 'mine=" + TouchstoneProgram() + " serve cookbook'";
  const Ended run = Itself("run contact/sphere_sphere --subject mine --against cookbook" +
                           program + " --fail-on subject");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("OK: mine never failed"));

  Write("mine/drop.toml", kDrop);
  const Ended motion =
      Itself("simulate " + Path("mine/drop.toml") + program + " --oracle mine");
  EXPECT_EQ(motion.code, 0) << motion.err;
  EXPECT_THAT(motion.out, HasSubstr("\nmine/drop,mine,0.1,ball,0,1.9"));

  const Ended timed = Itself(
      "bench contact --pair sphere sphere --count 100 --oracles "
      "cookbook,mine" +
      program);
  EXPECT_EQ(timed.code, 0) << timed.err;
  EXPECT_THAT(timed.out, HasSubstr("a program of its own: wall time"));
}

TEST_F(CommandLineTest, HasTheSameReportOfAProgramForAnyNumberOfJobs) {
  for (const char* jobs : {"1", "3"}) {
    const Ended ended = Itself(
        std::string("run contact/box_box world/free --subject mine --against cookbook "
                    "--oracle 'mine=") +
        TouchstoneProgram() + " serve cookbook' --jobs " + jobs + " --out " +
        Path(std::string("jobs") + jobs));
    EXPECT_EQ(ended.code, 0) << ended.err;
  }
  EXPECT_EQ(WithoutSeconds(Path("jobs1/report.jsonl")),
            WithoutSeconds(Path("jobs3/report.jsonl")));
}

TEST_F(CommandLineTest, ReadsTheProgramsOfAFile) {
  Write("oracles.toml", "mine = \"" + TouchstoneProgram() +
                            " serve cookbook\"\ngone = \"no_such_program\"\n");
  const std::string file = " --oracles " + Path("oracles.toml");
  const Ended listed = Itself("oracles" + file);
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("\nmine  Touchstone 0.1.0"));
  EXPECT_THAT(listed.out,
              HasSubstr("its program cannot be asked: exited with status 127"));
  // The file of the working folder needs no option.
  const Ended in_folder = InPipe("cd " + folder_.string() + " && " + TouchstoneProgram() +
                                 " ask --A 'sphere 1' --B 'sphere 1 @ 1 0 0' "
                                 "--against mine");
  EXPECT_EQ(in_folder.code, 0) << in_folder.err;
  EXPECT_THAT(in_folder.out, HasSubstr("mine"));
  EXPECT_EQ(Itself("run contact --subject gone" + file).code, 2);

  Write("oracles.toml", "mine = 3\n");
  const Ended wrong = Itself("oracles" + file);
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("oracles.toml:1:8: mine has no command; expected"));
}

TEST_F(CommandLineTest, SaysWhyAProgramIsNoOracle) {
  const Ended ended = Itself("run contact --oracle mine=false --subject mine");
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(
      ended.err,
      "touchstone: the oracle mine cannot be asked: exited with status 1; expected a "
      "program that speaks the oracle protocol (docs/oracle_protocol.md)\n");
  EXPECT_THAT(Itself("run contact --oracle mine").err,
              HasSubstr("--oracle mine is no program; expected NAME=COMMAND"));
  EXPECT_THAT(Itself("run contact --oracle 'ode=true'").err, HasSubstr("ode"));
  EXPECT_THAT(Itself("run contact --oracle 'a b=true'").err,
              HasSubstr("--oracle: \"a b\" is no name; expected"));
}

TEST_F(CommandLineTest, ChecksThatAProgramIsAnOracle) {
  const Ended right =
      Itself("check-oracle -- " + TouchstoneProgram() + " serve cookbook");
  EXPECT_EQ(right.code, 0) << right.out << right.err;
  EXPECT_THAT(right.out, HasSubstr("Nothing is wrong: 4 pairs and 4 worlds checked"));
  const Ended wrong = Itself("check-oracle fcl/collide_indep");
  EXPECT_EQ(wrong.code, 1) << wrong.err;
  EXPECT_THAT(wrong.out, HasSubstr("its normal is in the frame of A"));
  const Ended none = Itself("check-oracle -- false");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("`false` is no oracle: exited with status 1"));
}

TEST_F(CommandLineTest, SimulatesNoContactQueries) {
  const Ended ended = Itself("simulate " + Path("mine/deep.toml"));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("the selected scenarios are contact queries"));
}

TEST_F(CommandLineTest, RefusesToReproduceWhatIsNoFaultOfAnEngine) {
  Write("mine/drop.toml", kDrop);
  const std::string out = Path("fault");
  const auto error = [&](const Ended& ended) {
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(out));
    return ended.err;
  };
  const std::string deep = "reproduce " + Path("mine/deep.toml") + " --out " + out;
  const std::string drop = "reproduce " + Path("mine/drop.toml") + " --out " + out;
  EXPECT_THAT(error(Itself(deep + " --for bulet")),
              HasSubstr("'bulet' (did you mean bullet?)"));
  EXPECT_THAT(error(Itself(deep + " --for bullet")),
              HasSubstr("no answer of bullet is proved wrong in mine/deep"));
  EXPECT_THAT(error(Itself(drop + " --for bullet")),
              HasSubstr("no answer of bullet is proved wrong in mine/drop; expected"));
  EXPECT_THAT(error(Itself(drop + " --for bullet/gjk")),
              HasSubstr("is proved wrong in mine/drop: simulates no worlds; expected"));
  EXPECT_THAT(
      error(Touchstone(deep + " --for half_depth")),
      HasSubstr("mine/deep cannot be reproduced: half_depth is no engine of its own"));
}

TEST_F(CommandLineTest, TakesTheOracleIfItsGroupHasTheSameName) {
  // The hulls touch; neither bullet nor bullet/gjk finds that.
  const Ended ended = Itself(
      "reproduce contact/convex_hull_convex_hull/millimetres --for bullet "
      "--measure touching --out " +
      Path("fault"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("bullet: fail"));
  for (const std::string file : {"reproduce.cc", "CMakeLists.txt", "REPORT.md"})
    EXPECT_NE(TextOf(folder_ / "fault" / file), "") << file;
}

TEST_F(CommandLineTest, ShowsTimeAndQualityOfWorlds) {
  const Ended ended =
      Itself("bench worlds --scene stack20 --steps 3 --oracle cookbook,bullet");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr("a stack of 20 boxes: steps 4 to 6"),
                               HasSubstr("  cookbook"), HasSubstr("  bullet")));
}

// Returns the quality of the world in the row of `oracle`: the last three numbers.
std::string QualityIn(const std::string& table, const std::string& oracle) {
  const std::size_t row = table.find("\n  " + oracle + "  ");
  if (row == std::string::npos) return "no row of " + oracle + " in " + table;
  const std::string line = table.substr(row + 1, table.find('\n', row + 1) - row - 1);
  return line.substr(line.find("×"));
}

// 100 boxes fall on each other in the first 200 steps.
TEST_F(CommandLineTest, TimesTheCookbookWithThreadsThatDoNotChangeTheWorld) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one processor";
  const Ended ended = Itself(
      "bench worlds --scene boxes100 --steps 100 --threads 2 --oracle cookbook,bullet");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("4.167 ms, wall time of the best turn\n"),
                    HasSubstr("\n  cookbook: 2 threads are "),
                    HasSubstr("× as fast as one\n"), Not(HasSubstr("bullet, 2"))));
  const std::string quality = QualityIn(ended.out, "cookbook");
  EXPECT_EQ(QualityIn(ended.out, "cookbook, 2 threads"), quality);
  EXPECT_NE(QualityIn(ended.out, "bullet"), quality);
}

TEST_F(CommandLineTest, TimesOneThreadByDefault) {
  const Ended ended = Itself("bench worlds --scene stack20 --steps 3 --oracle cookbook");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, AllOf(HasSubstr(", CPU time, medians of the turns\n"),
                               Not(HasSubstr(" threads "))));
}

TEST_F(CommandLineTest, ShowsTheGrowthOfTimesWithTheSizeOfAWorld) {
  const Ended ended = Itself(
      "bench worlds --scene stack20,boxes100,boxes1000 --steps 3 --oracle cookbook");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("\ngrowth of µs/step with the number n of boxes\n"),
                    HasSubstr(" 100 to 1,000\n  cookbook "), HasSubstr(" n^"),
                    Not(HasSubstr("of stacked boxes"))));
}

TEST_F(CommandLineTest, RefusesThreadsIfNoOracleSupportsThem) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one processor";
  const Ended ended =
      Itself("bench worlds --scene stack20 --steps 3 --threads 2 --oracle bullet");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("none of these oracles steps in several threads"));
}

TEST_F(CommandLineTest, RefusesBenchOptionsOfTheOtherKindOfQuestion) {
  const Ended worlds = Itself("bench worlds --scene stack20 --pair box box");
  EXPECT_EQ(worlds.code, 2);
  EXPECT_EQ(worlds.out, "");
  EXPECT_EQ(worlds.err,
            "touchstone: --pair is not an option of `bench worlds`; expected it with "
            "contact\n");
  const Ended contact = Itself("bench contact --count 5 --threads 2");
  EXPECT_EQ(contact.code, 2);
  EXPECT_THAT(contact.err, HasSubstr("--threads is not an option of `bench contact`"));
}

TEST_F(CommandLineTest, FailsIfNoTimeWasMeasured) {
  const Ended ended = Itself(
      "bench worlds --scene stack20 --steps 1000000 --seconds 1 --oracle cookbook");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("nothing was measured"));
}

TEST_F(CommandLineTest, ShowsExamplesAndExitCodesInHelp) {
  const Ended ended = Touchstone("--help");
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("touchstone run mine.toml --out report"));
  for (const std::string command :
       {"run", "list", "oracles", "explain", "ask", "simulate", "sweep", "bench",
        "ledger", "accuracy", "schema", "shrink", "reproduce"}) {
    const Ended help = Touchstone(command + " --help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_THAT(help.out, AllOf(HasSubstr("\nExamples:\n  touchstone " + command),
                                HasSubstr("\nExit code: 0 ")));
  }
}

}  // namespace
}  // namespace touchstone
