#include "reports/writers/html_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hand_made_report.h"
#include "reports/writers/data/base64.h"

namespace touchstone {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const RunFacts kFacts{.program = "touchstone", .command = "touchstone run"};

std::string Page() {
  std::ostringstream out;
  WriteHtml(HandMadeReport(), kFacts, out);
  return out.str();
}

TEST(Base64, WritesTheVectorsOfItsStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(Base64("\xff\xfe\x3e"), "//4+");
}

TEST(WriteHtml, LoadsNothing) {
  const std::string page = Page();
  for (const char* loading : {"<link", "@import", "<script src", "<img src=\"http"})
    EXPECT_THAT(page, Not(HasSubstr(loading)));
}

TEST(WriteHtml, PutsTheDataIntoTheirElementAndNowhereElse) {
  const std::string page = Page();
  const std::string data = Base64(ReportData(HandMadeReport(), kFacts));
  EXPECT_THAT(page, HasSubstr("id=\"report-data\">" + data + "</script>"));
  EXPECT_THAT(data, Not(HasSubstr("<")));
  // Text from an engine or a user is in the data alone.
  EXPECT_THAT(page, Not(HasSubstr("out again")));
}

TEST(WriteHtml, WritesTheSameBytesForTheSameReport) {
  EXPECT_EQ(Page(), Page());
}

}  // namespace
}  // namespace touchstone
