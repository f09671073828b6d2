#include "reports/reproduce/cpp_text.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchstone {
namespace {

RC_GTEST_PROP(Literal, ReadsBackAsTheSameDouble, (double x)) {
  RC_PRE(std::isfinite(x));
  RC_ASSERT(std::strtod(Literal(x).c_str(), nullptr) == x);
}

TEST(Literal, IsADoubleEvenForIntegersAndKeepsTheSignOfZero) {
  EXPECT_EQ(Literal(1), "1.0");
  EXPECT_EQ(Literal(-3), "-3.0");
  EXPECT_EQ(Literal(-0.0), "-0.0");
  EXPECT_EQ(Literal(0.1), "0.1");
}

TEST(Literal, ReadsBackAtTheEndsOfTheRange) {
  using Limits = std::numeric_limits<double>;
  for (const double x : {Limits::max(), Limits::min(), Limits::denorm_min(), 1e22,
                         1 + Limits::epsilon(), 1e16, 123456789012345680.0}) {
    const std::string text = Literal(x);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), x) << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text;
  }
}

TEST(Quoted, LetsNoTextEndTheLiteral) {
  EXPECT_EQ(Quoted(R"(a "b" \)"), R"("a \"b\" \\")");
  EXPECT_EQ(Quoted("two\nlines\r"), R"("two lines ")");
  EXPECT_EQ(Quoted("5 % */ // ok"), R"("5 % */ // ok")");
}

TEST(Quoted, FormsNoTrigraph) {
  EXPECT_EQ(Quoted("what?"
                   "?/"),
            R"("what\?\?/")");
}

}  // namespace
}  // namespace touchstone
