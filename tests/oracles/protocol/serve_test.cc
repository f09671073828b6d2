// Replays conversations: tests/oracles/protocol/transcripts/*.txt. A line that starts
// with
// "> " is sent, and the lines that start with "< " are the answers, byte for byte.

#include "oracles/protocol/serve.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "oracles/function_oracle.h"
#include "oracles/function_simulator.h"
#include "oracles/isolation/answer_wire.h"
#include "oracles/protocol/answer_message.h"
#include "oracles/protocol/hello_message.h"
#include "oracles/protocol/query_message.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Returns what Serve() writes when `sent` is its whole input.
std::string Answered(const Oracle& oracle, const std::string& sent) {
  const File input(std::tmpfile(), &std::fclose);
  const File output(std::tmpfile(), &std::fclose);
  std::fwrite(sent.data(), 1, sent.size(), input.get());
  std::rewind(input.get());
  EXPECT_TRUE(Serve(oracle, fileno(input.get()), fileno(output.get())));
  std::string answered(static_cast<std::size_t>(lseek(fileno(output.get()), 0, SEEK_END)),
                       '\0');
  EXPECT_EQ(pread(fileno(output.get()), answered.data(), answered.size(), 0),
            static_cast<ssize_t>(answered.size()));
  return answered;
}

std::unique_ptr<Oracle> Balls() {
  return MakeOracle<Sphere, Sphere>(
      "balls", [](const Sphere& A, const Pose& X_WA, const Sphere& B, const Pose& X_WB) {
        const Eigen::Vector3d p_AB_W = X_WB.p_WB - X_WA.p_WB;
        if (p_AB_W.isZero()) throw std::domain_error("one centre, no normal");
        ContactAnswer answer;
        answer.status = AnswerStatus::kAnswered;
        answer.separation = p_AB_W.norm() - A.radius - B.radius;
        answer.touching = *answer.separation <= 0;
        answer.n_AB_W = p_AB_W.normalized();
        return answer;
      });
}

/** A world of bodies that fall freely, whatever is below them. */
class Falling final : public Simulation {
 public:
  explicit Falling(const World& world) : world_(world) {
    for (const RigidBody& body : world.bodies) {
      state_.bodies.push_back({body.placed.X_WB.p_WB,
                               Eigen::Quaterniond(body.placed.X_WB.R_WB), body.v_WB,
                               body.w_WB});
    }
  }

  void Push(int body, const Eigen::Vector3d&, const Eigen::Vector3d& J_W) override {
    const auto i = static_cast<std::size_t>(body);
    state_.bodies[i].v_WB += J_W / world_.bodies[i].mass;
  }
  void Step() override {
    for (BodyState& body : state_.bodies) {
      body.v_WB += world_.dt * world_.gravity_W;
      body.p_WB += world_.dt * body.v_WB;
    }
  }
  void Read(WorldState& state) const override { state = state_; }

 private:
  const World& world_;
  WorldState state_;
};

std::string Line(const std::string& text, std::size_t& begin) {
  const std::size_t end = text.find('\n', begin);
  std::string line = text.substr(begin, end - begin);
  begin = end == std::string::npos ? text.size() : end + 1;
  return line;
}

void Replay(const Oracle& oracle, const std::string& name) {
  std::ifstream file(InSourceTree("tests/oracles/protocol/transcripts/" + name));
  ASSERT_TRUE(file) << name;
  std::string sent;
  std::vector<std::string> expected;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("> ")) sent += line.substr(2) + '\n';
    if (line.starts_with("< ")) expected.push_back(line.substr(2));
  }
  ASSERT_GT(expected.size(), 2U);
  const std::string answered = Answered(oracle, sent);
  std::size_t begin = 0;
  for (const std::string& line : expected) EXPECT_EQ(Line(answered, begin), line);
  EXPECT_EQ(answered.substr(begin), "");
}

TEST(Serve, AnswersContactQuestionsAsTheTranscriptSays) {
  Replay(*Balls(), "balls.txt");
}

TEST(Serve, AnswersWorldsAsTheTranscriptSays) {
  Replay(*MakeSimulator<Falling>(
             "falling", {.simulates = {WorldFeature::kSphere, WorldFeature::kPush}}),
         "falling.txt");
}

TEST(Serve, AnswersFramesWithFrames) {
  const std::vector<ContactQuery> queries = {
      {{Sphere{1}, {}},
       {Sphere{1}, Pose::FromMatrix({1.5, 0, 0}, Eigen::Matrix3d::Identity())}},
      {{Sphere{1}, {}}, {Sphere{1}, {}}},
      {{Sphere{1}, {}}, {Box{{1, 1, 1}}, {}}}};
  Message asked{{{"id", 5}, {"method", "contact"}}, {}};
  PutQueries(queries, true, asked);
  const std::string answered = Answered(*Balls(), BytesOf(asked));
  const std::size_t end = answered.find('\n');
  Message answer{LineFrom(std::string_view(answered).substr(0, end)), {}};
  EXPECT_EQ(answer.line["id"], 5);
  answer.frame = FrameFrom(std::string_view(answered).substr(end + 1));
  const std::vector<ContactAnswer> answers = AnswersFrom(answer, 3);
  EXPECT_EQ(*answers[0].separation, -0.5);
  EXPECT_EQ(answers[1].status, AnswerStatus::kCrashed);
  EXPECT_EQ(answers[1].reason, "threw std::domain_error: one centre, no normal");
  EXPECT_EQ(answers[2].status, AnswerStatus::kUnsupported);
}

TEST(Serve, EndsAtAFrameThatIsCutOff) {
  EXPECT_EQ(Answered(*Balls(), "{\"id\":1,\"method\":\"contact\",\"frame\":80}\nshort"),
            "");
}

}  // namespace
}  // namespace touchstone
