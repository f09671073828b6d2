#include "reports/text/wrapped.h"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(Wrapped, BreaksAtSpacesAndIndentsWhatFollows) {
  EXPECT_EQ(Wrapped("one two three four", 9, 2), "one two\n  three\n  four");
  EXPECT_EQ(Wrapped("one two", 7, 2), "one two");
  EXPECT_EQ(Wrapped("  indented text", 12, 4), "  indented\n    text");
  EXPECT_EQ(Wrapped("unbreakable", 4, 0), "unbreakable");
  EXPECT_EQ(Wrapped("", 4, 0), "");
}

TEST(Wrapped, CountsCharactersAndNotBytes) {
  EXPECT_EQ(Wrapped("µµµ µµµ", 7, 0), "µµµ µµµ");
}

TEST(Wrapped, BreaksNothingWithoutAWidth) {
  const std::string text(500, 'a');
  EXPECT_EQ(Wrapped(text + " b", 0, 2), text + " b");
}

}  // namespace
}  // namespace touchstone
