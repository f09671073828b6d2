#include "reports/triage/triage_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/fake_oracle.h"
#include "tests/reports/triage/boxes_and_balls.h"

namespace touchstone {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class TriageIndexTest : public testing::Test {
 protected:
  TriageIndexTest() {
    const Scenario question = BoxAnd(Sphere{0.5}, {1.3, 0.1, 0.2});
    for (const Oracle* const oracle : {&deep_, &shallow_})
      specimens_.push_back(SmallestIn(question, *oracle));
    roots_ = RootsAmongBoxesAndBalls(specimens_);
  }

  const FakeOracle deep_ =
      FakeOracle::Wrong("deep", [](const ContactQuery&, ContactAnswer& answer) {
        if (answer.separation) *answer.separation -= 0.2;
      });
  const FakeOracle shallow_ = FakeOracle::Wrong(
      "shallow",
      [](const ContactQuery&, ContactAnswer& answer) { answer.points.clear(); });
  std::vector<Specimen> specimens_;
  std::vector<Root> roots_;
};

TEST_F(TriageIndexTest, ListsWhatIsNewSinceTheBaselineFirst) {
  ASSERT_EQ(roots_.size(), 2U);
  const TriageIndex index{.source = "night/sweep.sqlite",
                          .asked = "deep (Lib 1.2)",
                          .failed = 12,
                          .unproved = 1,
                          .roots = {{.root = &roots_[0], .folder = "old"},
                                    {.root = &roots_[1],
                                     .folder = "fresh",
                                     .is_new = true,
                                     .is_fresh = true}},
                          .unrepeatable = {specimens_[0]},
                          .left_out = 3,
                          .has_baseline = true};
  const std::string page = IndexPage(index);
  EXPECT_THAT(page, testing::Not(HasSubstr("ended early")));
  EXPECT_LT(page.find("(fresh/REPORT.md)"), page.find("(old/REPORT.md)"));
  EXPECT_THAT(
      page, AllOf(HasSubstr("2 root causes, 1 of them new since the baseline."),
                  HasSubstr("3 kinds of failure were not examined: the time was over."),
                  HasSubstr("**new since the baseline**, not in the ledger"),
                  HasSubstr("## Not repeated"), HasSubstr("asked deep (Lib 1.2)."),
                  HasSubstr("They have 10 of 12 failures."),
                  HasSubstr("1 answer differs from those of other oracles and is not")));
}

TEST_F(TriageIndexTest, SaysThatRatesOfASearchSayNothing) {
  TriageIndex index;
  EXPECT_THAT(IndexPage(index), testing::Not(HasSubstr("worst-case search")));
  index.is_search = true;
  EXPECT_THAT(IndexPage(index), HasSubstr("The rates say nothing"));
}

TEST_F(TriageIndexTest, EscapesWhatMarkdownWouldRead) {
  roots_[0].key.shapes = "a || b[i]";
  TriageIndex index;
  index.roots = {{.root = &roots_[0], .folder = "old"}};
  EXPECT_THAT(IndexPage(index), HasSubstr("a \\|\\| b\\[i\\]"));
}

TEST_F(TriageIndexTest, KeepsTheKeysOfTheRoots) {
  const std::string keys = KeysFile(roots_);
  for (const Root& root : roots_) {
    for (const std::string& line : KeyLinesOf(root))
      EXPECT_THAT(keys, HasSubstr(line + "\n"));
  }
  EXPECT_EQ(std::ranges::count(keys, '\n'), 2);
}

}  // namespace
}  // namespace touchstone
