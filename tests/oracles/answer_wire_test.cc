#include "oracles/answer_wire.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

using Eigen::Vector3d;

// Everything set, to values whose bits matter.
ContactAnswer FullAnswer() {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.reason = "a line\nwith a \0 in it";
  answer.touching = true;
  answer.n_AB_W = Vector3d(-0.0, std::nextafter(1.0, 2.0), 1e-310);
  answer.separation = -std::numeric_limits<double>::infinity();
  answer.witnesses = WitnessPoints{{1, 2, 3}, {0.1, 0.2, 0.3}};
  answer.points.push_back({{4, 5, 6}, -0.25, std::nullopt});
  answer.points.push_back({{7, 8, 9}, -0.0, Vector3d(0, 0, -1)});
  return answer;
}

// == would let -0.0 pass for 0.0 and fail for NaN.
::testing::AssertionResult SameBits(const Vector3d& a, const Vector3d& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) {
      return ::testing::AssertionFailure()
             << a.transpose() << " is not " << b.transpose();
    }
  }
  return ::testing::AssertionSuccess();
}

TEST(AnswerWire, KeepsEveryFieldBitForBit) {
  const ContactAnswer sent = FullAnswer();
  const auto received = FromWire(ToWire(sent));
  ASSERT_TRUE(received);
  EXPECT_EQ(received->status, sent.status);
  EXPECT_EQ(received->reason, sent.reason);
  EXPECT_EQ(received->touching, sent.touching);
  EXPECT_TRUE(SameBits(*received->n_AB_W, *sent.n_AB_W));
  EXPECT_EQ(received->separation, sent.separation);
  EXPECT_TRUE(SameBits(received->witnesses->p_WCa, sent.witnesses->p_WCa));
  EXPECT_TRUE(SameBits(received->witnesses->p_WCb, sent.witnesses->p_WCb));
  ASSERT_EQ(received->points.size(), 2u);
  EXPECT_TRUE(SameBits(received->points[0].p_WC, sent.points[0].p_WC));
  EXPECT_FALSE(received->points[0].n_AB_W);
  EXPECT_TRUE(std::signbit(received->points[1].separation));
  EXPECT_TRUE(SameBits(*received->points[1].n_AB_W, *sent.points[1].n_AB_W));
}

TEST(AnswerWire, KeepsNaN) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.separation = std::numeric_limits<double>::quiet_NaN();
  answer.n_AB_W = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto received = FromWire(ToWire(answer));
  ASSERT_TRUE(received);
  EXPECT_TRUE(std::isnan(received->separation.value()));
  EXPECT_TRUE(SameBits(received->n_AB_W.value(), *answer.n_AB_W));
}

TEST(AnswerWire, KeepsEmptyFieldsEmpty) {
  const auto received = FromWire(ToWire(ContactAnswer{}));
  ASSERT_TRUE(received);
  EXPECT_EQ(received->status, AnswerStatus::kUnsupported);
  EXPECT_FALSE(received->n_AB_W || received->separation || received->witnesses);
  EXPECT_TRUE(received->points.empty());
}

TEST(AnswerWire, RefusesEveryTruncationAndEveryExtraByte) {
  const std::string bytes = ToWire(FullAnswer());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(FromWire(std::string_view(bytes).substr(0, length))) << length;
  }
  EXPECT_FALSE(FromWire(bytes + '\0'));
}

TEST(AnswerWire, RefusesAnotherVersionAndUnknownValues) {
  for (const std::size_t place : {0u, 1u, 2u}) {  // Version, status, flags.
    std::string bytes = ToWire(FullAnswer());
    bytes[place] = '\x7f';
    EXPECT_FALSE(FromWire(bytes)) << place;
  }
}

// What is accepted must be what ToWire() writes: nothing is made up or read past the end
// (which the sanitizers watch), and no length in the bytes is believed.
TEST(AnswerWire, SurvivesAnyBytes) {
  std::mt19937_64 random(99);
  const std::string sound = ToWire(FullAnswer());
  int accepted = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes = sound;
    for (int k = 0; k < 3; ++k)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    bytes.resize(random() % 8 == 0 ? random() % bytes.size() : bytes.size());
    if (const auto answer = FromWire(bytes)) {
      EXPECT_EQ(ToWire(*answer), bytes);
      ++accepted;
    }
  }
  EXPECT_GT(accepted, 1000);
}

}  // namespace
}  // namespace touchstone
