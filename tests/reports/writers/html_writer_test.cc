#include "reports/writers/html_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"

namespace touchstone {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string Html(const RunReport& report) {
  std::ostringstream out;
  WriteHtml(report, out);
  return out.str();
}

TEST(WriteHtml, LoadsNothing) {
  const std::string page = Html(HandMadeReport());
  for (const char* loading : {"src=", "<link", "@import", "url(", "fetch(", "http://"}) {
    EXPECT_THAT(page, Not(HasSubstr(loading)));
  }
}

TEST(WriteHtml, ShowsTitleSourceTruthAnswersAndProofs) {
  const std::string page = Html(HandMadeReport());
  EXPECT_THAT(page, HasSubstr("A sphere in a &lt;box&gt; &amp; out again"));
  EXPECT_THAT(page,
              HasSubstr("Source: Derivation: centre at h + r - d on the face axis"));
  EXPECT_THAT(page, HasSubstr("the separation is -0.05 m"));
  EXPECT_THAT(page, HasSubstr("moving B by 0.04 along n leaves 0.01 of overlap"));
  EXPECT_THAT(page, HasSubstr("href=\"#ledger-0\""));
}

TEST(WriteHtml, WritesOneVerdictPerOracleForTheFilter) {
  EXPECT_THAT(Html(HandMadeReport()), HasSubstr("data-outcomes=\"fail invalid\""));
}

TEST(WriteHtml, DrawsEveryScenarioTwice) {
  const std::string page = Html(HandMadeReport());
  std::size_t drawings = 0;
  for (std::size_t at = page.find("<svg"); at != std::string::npos;
       at = page.find("<svg", at + 1)) {
    ++drawings;
  }
  EXPECT_EQ(drawings, 6u);
}

TEST(WriteHtml, WritesNoMultipleOfAZeroTolerance) {
  RunReport report = HandMadeReport();
  for (Finding& finding : report.findings) {
    if (finding.verdict == Verdict::kFail) finding.tolerance = 0;
  }
  EXPECT_THAT(Html(report), HasSubstr("<td>separation_error: 0.01 where 0 is allowed"));
  EXPECT_THAT(Html(report), Not(HasSubstr("inf ×")));
}

TEST(WriteHtml, LabelsTheCellsOfACardWithTheirColumns) {
  const std::string page = Html(HandMadeReport());
  EXPECT_THAT(page,
              HasSubstr(".oracles td:nth-child(4)::before { content: \"failed \"; }"));
  EXPECT_THAT(page,
              HasSubstr(".answers td:nth-child(8)::before { content: \"worst \"; }"));
  EXPECT_THAT(page, HasSubstr(".ledger td:nth-child(9)::before { content: \"expires \""));
  // The columns in this order: pass, known, failed; hides, of, worst accepted.
  EXPECT_THAT(page, HasSubstr("<tr><td>mine <b>(subject)</b><td class=\"n pass\">1"
                              "<td class=\"n soft\">0<td class=\"n fail\">1"));
  EXPECT_THAT(page, HasSubstr("<td>theirs/float 1.2<td>contact/box_sphere/*"
                              "<td class=\"n\">1<td class=\"n\">2"
                              "<td>separation_error 1e-07 of 1e-06"));
}

TEST(WriteHtml, ListsOnlyTheLedgerEntriesThatTheRunTested) {
  const std::string page = Html(HandMadeReport());
  EXPECT_THAT(page, HasSubstr("id=\"ledger-0\""));
  EXPECT_THAT(page, Not(HasSubstr("id=\"ledger-1\"")));
  EXPECT_THAT(page, HasSubstr("1 entry was not tested by this run."));
}

TEST(WriteHtml, ScrollsTheTargetOfALinkToBelowTheFilter) {
  EXPECT_THAT(Html(HandMadeReport()), HasSubstr("html { scroll-padding-top: 4.5rem; }"));
}

TEST(WriteHtml, WritesTheSameBytesForTheSameReport) {
  EXPECT_EQ(Html(HandMadeReport()), Html(HandMadeReport()));
}

TEST(WriteHtml, ListsTheOraclesInTheOrderOfTheSigns) {
  std::ostringstream out;
  WriteHtml(HandMadeReport(), out);
  EXPECT_THAT(out.str(),
              HasSubstr("<ol class=\"legend\">\n<li>mine\n<li>theirs/float\n"));
}

TEST(WriteHtml, NamesTheReferencesThatFailTheRunIfTheSubjectIsRight) {
  RunReport report = HandMadeReport();
  for (Finding& finding : report.findings) {
    if (finding.oracle == "mine") finding.verdict = Verdict::kPass;
  }
  std::ostringstream out;
  WriteHtml(report, out);
  EXPECT_THAT(out.str(), HasSubstr("No error was found"));
  EXPECT_THAT(out.str(), HasSubstr("References are wrong</b>: theirs/float. This fails"));
}

}  // namespace
}  // namespace touchstone
