#include "oracles/isolation/recording_child.h"

#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchstone {
namespace {

using std::chrono::milliseconds;

constexpr ChildLimits kLimits = {milliseconds(1000), milliseconds(10'000),
                                 std::size_t{1} << 30, std::size_t{1} << 20};

std::optional<std::string> AsText(std::string_view bytes) {
  return std::string(bytes);
}

TEST(RecordingChild, HasTheAnswersThatItGaveBeforeItDied) {
  RecordingChild child(
      5,
      [](std::size_t question) {
        if (question == 3) std::abort();
        return "answer " + std::to_string(question);
      },
      kLimits);
  for (const char* answer : {"answer 0", "answer 1", "answer 2"})
    EXPECT_EQ(child.Next(&AsText), answer);
  EXPECT_EQ(child.Next(&AsText), std::nullopt);
  EXPECT_FALSE(child.IsFull());
  EXPECT_EQ(child.LastWords().reason, "aborted");
}

// A file cannot grow for ever. The next child goes on with the first question without an
// answer, and no question is blamed.
TEST(RecordingChild, StopsBetweenQuestionsOnceItsRecordsAreFull) {
  const std::string answer(1'000'000, 'x');
  RecordingChild child(
      1000, [&](std::size_t) { return answer; }, kLimits);
  std::size_t answered = 0;
  while (child.Next(&AsText) == answer) ++answered;
  // 16 MiB, and the answer that reaches them.
  EXPECT_EQ(answered, 17U);
  EXPECT_TRUE(child.IsFull());
}

TEST(RecordingChild, IsNotReadBeyondAnAnswerThatIsTooLong) {
  ChildLimits limits = kLimits;
  limits.message = 10;
  RecordingChild child(
      3,
      [](std::size_t question) {
        return question == 1 ? std::string("longer than ten") : std::string("short");
      },
      limits);
  EXPECT_EQ(child.Next(&AsText), "short");
  EXPECT_EQ(child.Next(&AsText), std::nullopt);
  EXPECT_EQ(child.LastWords().reason, "sent bytes that are not an answer");
}

// The engine waits, and has recorded nothing for longer than is allowed.
TEST(RecordingChild, IsStoppedIfItBlocks) {
  ChildLimits limits = kLimits;
  limits.wall = milliseconds(1000);
  RecordingChild child(
      2,
      [](std::size_t question) {
        if (question == 1) pause();
        return std::string("first");
      },
      limits);
  EXPECT_EQ(child.Next(&AsText), "first");
  EXPECT_EQ(child.Next(&AsText), std::nullopt);
  EXPECT_EQ(child.LastWords().reason, "no answer after 1 s, blocked");
}

// Every question has its own wall-clock time: the limit is for one, not for all.
TEST(RecordingChild, MayTakeLongerThanTheLimitInAll) {
  ChildLimits limits = kLimits;
  limits.wall = milliseconds(1000);
  RecordingChild child(
      5,
      [](std::size_t) {
        usleep(300'000);
        return std::string("slow");
      },
      limits);
  int answered = 0;
  while (child.Next(&AsText)) ++answered;
  EXPECT_EQ(answered, 5);
}

}  // namespace
}  // namespace touchstone
