#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/ledger/glob.h"
#include "reports/ledger/ledger_file.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kEntry = R"([[entry]]
scenarios = "contact/box_box/*"
oracle = "ode"
version = "0.16.2"
verdict = "fail"
measures = ["separation_error", "excess"]
cause = "defect"
reason = "Prefers a face axis by 5 %."
upstream = "unreported"
expires = 2026-06-30
)";

std::vector<std::string> Complaints(std::string_view text) {
  std::vector<std::string> complaints;
  for (const Diagnostic& d : ReadLedger(text, "ledger.toml").diagnostics) {
    complaints.push_back(ToString(d));
  }
  return complaints;
}

/** Returns kEntry with `before` replaced by `after`. */
std::string With(std::string_view before, std::string_view after) {
  std::string text(kEntry);
  text.replace(text.find(before), before.size(), after);
  return text;
}

TEST(ReadLedger, ReadsEveryField) {
  const LedgerResult result = ReadLedger(kEntry, "ledger.toml");
  ASSERT_THAT(result.diagnostics, IsEmpty());
  ASSERT_EQ(result.ledger->entries.size(), 1U);
  const LedgerEntry& entry = result.ledger->entries[0];
  EXPECT_THAT(entry.scenarios, ElementsAre("contact/box_box/*"));
  EXPECT_EQ(entry.oracle, "ode");
  EXPECT_EQ(entry.version, "0.16.2");
  EXPECT_EQ(entry.verdict, Verdict::kFail);
  EXPECT_THAT(entry.measures,
              ElementsAre(MeasureKind::kSeparationError, MeasureKind::kExcess));
  EXPECT_THAT(entry.causes, ElementsAre(Cause::kDefect));
  EXPECT_EQ(entry.reason, "Prefers a face axis by 5 %.");
  EXPECT_EQ(entry.upstream, "unreported");
  EXPECT_EQ(entry.expires, "2026-06-30");
  EXPECT_EQ(entry.line, 1);
}

TEST(ReadLedger, ReadsWhoIsResponsible) {
  const LedgerResult silent = ReadLedger(kEntry, "ledger.toml");
  EXPECT_EQ(silent.ledger->entries[0].responsible, Responsible::kEngine);
  const std::string adapter = With("reason =", "responsible = \"adapter\"\nreason =");
  const LedgerResult result = ReadLedger(adapter, "ledger.toml");
  ASSERT_THAT(result.diagnostics, IsEmpty());
  EXPECT_EQ(result.ledger->entries[0].responsible, Responsible::kAdapter);
  EXPECT_EQ(ReadLedger(WriteLedgerEntry(result.ledger->entries[0], ""), "ledger.toml")
                .ledger->entries[0]
                .responsible,
            Responsible::kAdapter);
  EXPECT_THAT(Complaints(With("reason =", "responsible = \"user\"\nreason =")),
              ElementsAre("ledger.toml:8:15: responsible is \"user\"; expected one of "
                          "engine, adapter, model"));
}

TEST(ReadLedger, ReadsAListOfGlobs) {
  const LedgerResult result = ReadLedger(
      With("\"contact/box_box/*\"", "[\"contact/zoo/*\", \"world/**\"]"), "ledger.toml");
  EXPECT_THAT(result.ledger->entries[0].scenarios,
              ElementsAre("contact/zoo/*", "world/**"));
  for (const std::string_view empty : {"[]", "\"\"", "[\"\"]"}) {
    EXPECT_THAT(Complaints(With("\"contact/box_box/*\"", empty)),
                ElementsAre(testing::EndsWith(
                    "scenarios is empty; expected a glob over scenario ids, or a list of "
                    "globs")))
        << empty;
  }
  EXPECT_THAT(Complaints(With("\"contact/box_box/*\"", "[\"contact/*\", 3]")),
              ElementsAre(testing::HasSubstr("not a string or a list of them")));
}

TEST(ReadLedger, ReadsAListOfCauses) {
  const LedgerResult result =
      ReadLedger(With("\"defect\"", "[\"tie\", \"defect\"]"), "ledger.toml");
  EXPECT_THAT(result.ledger->entries[0].causes, ElementsAre(Cause::kTie, Cause::kDefect));
  EXPECT_EQ(CausesOf(result.ledger->entries[0]), "tie, defect");
  EXPECT_THAT(Complaints(With("\"defect\"", "[\"tie\", \"tie\"]")),
              ElementsAre("ledger.toml:7:17: tie is named twice; expected each cause "
                          "once"));
  EXPECT_THAT(Complaints(With("\"defect\"", "[]")),
              ElementsAre(testing::HasSubstr("cause is empty")));
}

TEST(ReadLedger, TakesAFaultThatIsASentence) {
  const LedgerResult result =
      ReadLedger(std::string(kEntry).append("fault = \"It stops.\"\n"), "ledger.toml");
  EXPECT_EQ(result.ledger->entries[0].fault, "It stops.");
  EXPECT_THAT(
      Complaints(std::string(kEntry).append("fault = \"It stops\"\n")),
      ElementsAre("ledger.toml:11:9: fault has no stop; expected one sentence with its "
                  "stop: what goes wrong"));
}

TEST(ReadLedger, TreatsAnEntryAsSteadyUnlessItSaysIntermittent) {
  const auto intermittent = [](std::string_view line) {
    const LedgerResult result =
        ReadLedger(std::string(kEntry).append(line), "ledger.toml");
    return result.ledger->entries[0].intermittent;
  };
  EXPECT_FALSE(intermittent(""));
  EXPECT_FALSE(intermittent("intermittent = false\n"));
  EXPECT_TRUE(intermittent("intermittent = true\n"));
  EXPECT_THAT(
      Complaints(std::string(kEntry).append("intermittent = 1\n")),
      ElementsAre("ledger.toml:11:16: intermittent is not a boolean; expected true or "
                  "false"));
}

TEST(ReadLedger, AcceptsAnEmptyLedger) {
  EXPECT_THAT(Complaints("# Nothing is known.\n"), IsEmpty());
}

TEST(ReadLedger, RefusesAnEmptyReason) {
  EXPECT_THAT(
      Complaints(With("\"Prefers a face axis by 5 %.\"", "\"\"")),
      ElementsAre("ledger.toml:8:10: reason is empty; expected one or two sentences: "
                  "what goes wrong and why"));
}

TEST(ReadLedger, SuggestsTheKeyThatWasMeant) {
  EXPECT_THAT(
      Complaints(With("oracle =", "orcale =")),
      ElementsAre("ledger.toml:1:1: oracle is missing; expected the name of an oracle",
                  "ledger.toml:3:1: unknown key \"orcale\"; expected \"oracle\""));
}

TEST(ReadLedger, ListsTheValidMeasuresVerdictsAndCauses) {
  const auto complaints = Complaints(With("excess", "depth"));
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_THAT(
      complaints[0],
      testing::StartsWith("ledger.toml:6:33: measure is \"depth\"; expected one of "
                          "touching, separation_error, "));
  EXPECT_THAT(Complaints(With("\"fail\"", "\"pass\"")),
              ElementsAre("ledger.toml:5:11: verdict is \"pass\"; expected one of fail, "
                          "disagree, invalid, crashed, timed out"));
  EXPECT_THAT(
      Complaints(With("\"defect\"", "\"bug\"")),
      ElementsAre("ledger.toml:7:9: cause is \"bug\"; expected one of convention, tie, "
                  "precision, discretisation, model, setting, defect"));
}

TEST(ReadLedger, SaysWhoWritesBounds) {
  EXPECT_THAT(
      Complaints(With("measures = [\"separation_error\", \"excess\"]",
                      "bounds = { excess = 0.001 }")),
      ElementsAre("ledger.toml:1:1: measures is missing; expected a list of measures, "
                  "e.g. [\"separation_error\"]",
                  "ledger.toml:6:1: bounds are not written here; expected measures = "
                  "[...]; `touchstone ledger --update` writes the bounds"));
}

TEST(ReadLedger, RefusesNoMeasureAndAMeasureNamedTwice) {
  for (const std::string_view none : {"[]", "\"excess\"", "0.05"}) {
    EXPECT_THAT(
        Complaints(With("[\"separation_error\", \"excess\"]", none)),
        ElementsAre("ledger.toml:6:12: measures names no measure; expected a list of "
                    "measures, e.g. [\"separation_error\"]"));
  }
  EXPECT_THAT(Complaints(With("separation_error", "excess")),
              ElementsAre("ledger.toml:6:23: excess is named twice; expected each "
                          "measure once"));
}

TEST(ReadLedger, RequiresATomlDate) {
  EXPECT_THAT(
      Complaints(With("2026-06-30", "\"2026-06-30\"")),
      ElementsAre("ledger.toml:10:11: expires is not a date; expected a date, e.g. "
                  "2026-06-30"));
}

TEST(ReadLedger, ReportsAllErrorsAtOnceInTheOrderOfLines) {
  std::string text = With("excess", "much");
  text += With("\"unreported\"", "3");
  text += "[other]\n";
  const auto complaints = Complaints(text);
  ASSERT_EQ(complaints.size(), 3U);
  EXPECT_THAT(complaints[0], testing::StartsWith("ledger.toml:6:"));
  EXPECT_THAT(complaints[1], testing::StartsWith("ledger.toml:19:"));
  EXPECT_THAT(complaints[2], testing::StartsWith("ledger.toml:21:"));
}

TEST(ReadLedger, ReportsWhereTheTomlIsMalformed) {
  const auto complaints = Complaints("[[entry]\n");
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_THAT(complaints[0], testing::StartsWith("ledger.toml:1:"));
}

TEST(ReadLedger, ReadsBackWhatIsWritten) {
  const LedgerEntry entry = ReadLedger(kEntry, "ledger.toml").ledger->entries[0];
  EXPECT_EQ(WriteLedgerEntry(entry, ""), kEntry);
}

TEST(MatchesGlob, KeepsOneStarWithinALevel) {
  EXPECT_TRUE(MatchesGlob("contact/box_box/*", "contact/box_box/face_face"));
  EXPECT_TRUE(MatchesGlob("contact/*_box/face*", "contact/box_box/face_face"));
  EXPECT_FALSE(MatchesGlob("contact/*", "contact/box_box/face_face"));
  EXPECT_FALSE(MatchesGlob("contact/box_box", "contact/box_box/face_face"));
  EXPECT_FALSE(MatchesGlob("", "contact"));
}

TEST(MatchesGlob, LetsTwoStarsCrossLevels) {
  EXPECT_TRUE(MatchesGlob("**", "contact/box_box/face_face"));
  EXPECT_TRUE(MatchesGlob("contact/**", "contact/box_box/face_face"));
  EXPECT_TRUE(MatchesGlob("**/face_*", "contact/box_box/face_face"));
  EXPECT_FALSE(MatchesGlob("world/**", "contact/box_box/face_face"));
}

// The list of faults has two lines for a title.
TEST(ReadLedgerFile, FindsShortFaultsInThatOfTheCatalogue) {
  const LedgerResult result =
      ReadLedgerFile(InSourceTree("scenarios/known_discrepancies.toml"));
  ASSERT_TRUE(result.ledger);
  for (const LedgerEntry& entry : result.ledger->entries) {
    const std::string fault = FaultOf(entry);
    const auto continues = [](char c) { return (c & 0xC0) == 0x80; };
    EXPECT_LE(
        fault.size() - static_cast<std::size_t>(std::ranges::count_if(fault, continues)),
        110U)
        << entry.line << ": " << fault;
  }
}

}  // namespace
}  // namespace touchstone
