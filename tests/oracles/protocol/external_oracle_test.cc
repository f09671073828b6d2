// What programs that fail, in every way that we know, cost a run.

#include "oracles/protocol/external_oracle.h"

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace touchstone {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

constexpr double kFatal = 0.13;
constexpr std::size_t kFatalIndex = 2;

// A test waits for the short limits to pass, and for no other.
constexpr milliseconds kLong{600'000};
constexpr ExternalLimits kLimits{
    {kLong, kLong, 1 << 20}, {kLong, kLong, 1 << 16}, {kLong, kLong, 1 << 20}};

std::unique_ptr<Oracle> Faulty(const std::string& how, const std::string& file = "") {
  ExternalLimits limits = kLimits;
  if (how == "hang") limits.contact.wall = milliseconds(3'000);
  if (how == "work") limits.contact.cpu = milliseconds(1'000);
  return MakeExternalOracle(
      "mine", {std::string(FAULTY_PROGRAM) + " '" + how + "' '" + file + "'"}, limits);
}

ContactQuery Balls(double radius) {
  return {{Sphere{radius}, {}},
          {Sphere{0.5},
           Pose::FromQuaternion({0.6, 0.2, 0.1}, Eigen::Quaterniond::Identity())}};
}

std::vector<ContactQuery> FiveQuestions() {
  std::vector<ContactQuery> queries;
  for (const double radius : {0.1, 0.2, kFatal, 0.3, 0.4})
    queries.push_back(Balls(radius));
  return queries;
}

std::vector<ContactAnswer> Ask(const Oracle& oracle,
                               const std::vector<ContactQuery>& queries) {
  std::vector<ContactAnswer> answers(queries.size());
  oracle.Answer(queries, answers);
  return answers;
}

std::string FreshFile(const std::string& name) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / (name + std::to_string(getpid()));
  std::filesystem::remove(file);
  return file;
}

// Expects that all questions are answered but that at `index`.
void ExpectAnswersExcept(const std::vector<ContactAnswer>& answers, std::size_t index) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (i == index) continue;
    EXPECT_EQ(answers[i].status, AnswerStatus::kAnswered) << i << answers[i].reason;
    EXPECT_TRUE(answers[i].separation) << i;
  }
}

TEST(ExternalOracle, IsDescribedByItsProgram) {
  const auto oracle = Faulty("");
  const OracleInfo& info = oracle->info();
  EXPECT_EQ(info.name, "mine");
  EXPECT_EQ(info.version, "1");
  EXPECT_TRUE(info.For(ShapeKind::kSphere, ShapeKind::kSphere).depth);
  const Capability& other = info.For(ShapeKind::kBox, ShapeKind::kSphere);
  EXPECT_FALSE(other.supported);
  EXPECT_EQ(other.reason, "mine does not answer this pair");
  EXPECT_TRUE(info.isolated);
}

TEST(ExternalOracle, GivesTheAnswersOfItsProgram) {
  const auto oracle = Faulty("");
  const std::vector<ContactAnswer> answers = Ask(*oracle, FiveQuestions());
  ExpectAnswersExcept(answers, answers.size());
  EXPECT_TRUE(answers[0].touching == false);
  EXPECT_DOUBLE_EQ(*answers[0].separation, std::sqrt(0.41) - 0.6);
  EXPECT_TRUE(answers[4].touching);
}

/** A way to fail, and the answer to the question that causes it. */
struct Failure {
  std::string how;
  AnswerStatus status;
  std::string reason;
};

class FailingProgram : public testing::TestWithParam<Failure> {};

TEST_P(FailingProgram, CostsTheAnswerToTheQuestionThatCausedIt) {
  const auto oracle = Faulty(GetParam().how);
  const std::vector<ContactAnswer> answers = Ask(*oracle, FiveQuestions());
  ExpectAnswersExcept(answers, kFatalIndex);
  EXPECT_EQ(answers[kFatalIndex].status, GetParam().status);
  EXPECT_THAT(answers[kFatalIndex].reason, HasSubstr(GetParam().reason));
}

INSTANTIATE_TEST_SUITE_P(
    , FailingProgram,
    testing::Values(
        Failure{"abort", AnswerStatus::kCrashed, "aborted: assertion failed"},
        Failure{"exit", AnswerStatus::kCrashed, "exited with status 3"},
        Failure{"garbage", AnswerStatus::kCrashed,
                "sent \"depth is 0.3\"; expected a line of JSON, an object"},
        Failure{"flood", AnswerStatus::kCrashed, "sent a line of more than 65536 bytes"},
        Failure{"few answers", AnswerStatus::kCrashed,
                "answer.answers: []; expected a list of 1"},
        Failure{"another id", AnswerStatus::kCrashed,
                "answered with the id 77; expected"},
        Failure{"short normal", AnswerStatus::kCrashed,
                "answer.answers[2].normal: [1,0]; expected a list of 3 numbers"},
        Failure{"refuse", AnswerStatus::kCrashed, "no such ball"}),
    [](const auto& instance) {
      std::string name = instance.param.how;
      std::ranges::replace(name, ' ', '_');
      return name;
    });

// Only the question that is never answered is asked under a short limit: any other could
// be late on a busy machine.
TEST(ExternalOracle, GivesUpOnAProgramThatWaits) {
  const ContactAnswer answer = Faulty("hang")->Answer(Balls(kFatal));
  EXPECT_EQ(answer.status, AnswerStatus::kTimedOut);
  EXPECT_EQ(answer.reason, "no answer after 3 s, blocked");
}

TEST(ExternalOracle, GivesUpOnAProgramThatWorksForTooLong) {
  const ContactAnswer answer = Faulty("work")->Answer(Balls(kFatal));
  EXPECT_EQ(answer.status, AnswerStatus::kTimedOut);
  EXPECT_EQ(answer.reason, "no answer after 1 s of CPU time");
}

TEST(ExternalOracle, HandsOnANumberThatIsNone) {
  const std::vector<ContactAnswer> answers = Ask(*Faulty("nan"), FiveQuestions());
  EXPECT_EQ(answers[kFatalIndex].status, AnswerStatus::kAnswered);
  EXPECT_TRUE(std::isnan(*answers[kFatalIndex].separation));
}

TEST(ExternalOracle, IsNotHeldUpByMessagesOnStandardError) {
  ExpectAnswersExcept(Ask(*Faulty("messages"), FiveQuestions()), 5);
}

TEST(ExternalOracle, AsksOneByOneWhatIsAnsweredWithOneError) {
  const std::vector<ContactAnswer> answers = Ask(*Faulty("error"), FiveQuestions());
  ExpectAnswersExcept(answers, kFatalIndex);
  EXPECT_EQ(answers[kFatalIndex].status, AnswerStatus::kCrashed);
  EXPECT_EQ(answers[kFatalIndex].reason, "tired");
}

TEST(ExternalOracle, LosesOneAnswerToADeathThatDoesNotComeBack) {
  const auto oracle = Faulty("die once", FreshFile("die_once"));
  const std::vector<ContactAnswer> answers = Ask(*oracle, FiveQuestions());
  ExpectAnswersExcept(answers, 0);
  EXPECT_EQ(answers[0].status, AnswerStatus::kCrashed);
  EXPECT_EQ(answers[0].reason,
            "aborted, when this question and the 4 after it were asked together; each is "
            "answered when it is asked alone");
  ExpectAnswersExcept(Ask(*oracle, FiveQuestions()), 5);
}

TEST(ExternalOracle, LosesOneAnswerToADeathAlsoIfAnotherQuestionIsRefused) {
  const auto oracle = Faulty("die once and refuse", FreshFile("die_once_and_refuse"));
  const std::vector<ContactAnswer> answers = Ask(*oracle, FiveQuestions());
  EXPECT_EQ(answers[0].status, AnswerStatus::kCrashed);
  EXPECT_THAT(answers[0].reason,
              HasSubstr("aborted, when this question and the 4 after"));
  EXPECT_EQ(answers[kFatalIndex].reason, "no such ball");
}

TEST(ExternalOracle, AnswersAlikeWhenSeveralThreadsAsk) {
  const auto oracle = Faulty("");
  std::vector<ContactQuery> queries;
  queries.reserve(200);
  for (int i = 0; i < 200; ++i) queries.push_back(Balls(0.01 * (i + 1)));
  const std::vector<ContactAnswer> expected = Ask(*oracle, queries);
  std::vector<std::vector<ContactAnswer>> given(4);
  {
    std::vector<std::jthread> threads;
    threads.reserve(given.size());
    for (std::vector<ContactAnswer>& answers : given)
      threads.emplace_back([&] { answers = Ask(*oracle, queries); });
  }
  for (const std::vector<ContactAnswer>& answers : given) {
    for (std::size_t i = 0; i < queries.size(); ++i)
      EXPECT_EQ(answers[i].separation, expected[i].separation);
  }
}

TEST(ExternalOracle, DoesNotOutliveItsOwner) {
  const std::string file = FreshFile("pid");
  Faulty("pid", file).reset();
  pid_t pid = 0;
  std::ifstream(file) >> pid;
  ASSERT_GT(pid, 0);
  EXPECT_NE(kill(pid, 0), 0) << pid << " still runs";
}

/** A program that is no oracle, and what is said of it. */
struct Refused {
  std::string command;
  std::string reason;
};

TEST(ExternalOracle, SaysWhyAProgramIsNoOracle) {
  const std::string faulty = FAULTY_PROGRAM;
  const Refused kRefused[] = {
      {"no_such_program", "exited with status 127"},
      {"(exit 4)", "exited with status 4"},
      {faulty + " banner", "sent \"faulty engine, build 7\"; expected a line of JSON"},
      {faulty + " old", "hello.protocol: 0; expected a whole number from 1 to 1"},
      {faulty + " shapeless",
       "hello.contact[0].pairs[0][0]: \"ball\"; expected the name of a shape"},
  };
  for (const Refused& refused : kRefused) {
    try {
      MakeExternalOracle("mine", {refused.command}, kLimits);
      ADD_FAILURE() << refused.command << " was accepted";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(refused.reason)) << refused.command;
    }
  }
}

TEST(ExternalOracle, RunsItsCommandInItsFolder) {
  try {
    MakeExternalOracle("mine", {"pwd; exit 1", "/usr"}, kLimits);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("\"/usr\""));
  }
}

}  // namespace
}  // namespace touchstone
