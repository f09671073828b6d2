#include "oracles/answer_each.h"

#include <array>
#include <chrono>
#include <stdexcept>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

// An engine for spheres only, which throws on a sphere of radius 2.
ContactAnswer Ask(const ContactQuery& query) {
  // It takes time that every clock sees.
  using Clock = std::chrono::steady_clock;
  for (const auto start = Clock::now(); Clock::now() == start;) continue;
  if (std::get<Sphere>(query.A.shape).radius == 2) throw std::runtime_error("too fat");
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  return answer;
}

OracleInfo BallsOnly() {
  OracleInfo info;
  info.capabilities = CapabilityTable([](ShapeKind a, ShapeKind b) {
    Capability capability;
    capability.supported = a == ShapeKind::kSphere && b == ShapeKind::kSphere;
    if (!capability.supported) capability.reason = "balls only";
    return capability;
  });
  return info;
}

TEST(AnswerEach, ContinuesAfterUnsupportedPairsAndExceptions) {
  const Body ball{Sphere{1}, {}};
  const Body fat{Sphere{2}, {}};
  const Body box{Box{{1, 2, 3}}, {}};
  const std::array<ContactQuery, 4> queries = {
      {{ball, ball}, {ball, box}, {fat, ball}, {ball, fat}}};
  std::array<ContactAnswer, 4> answers;
  AnswerEach(BallsOnly(), queries, answers, Ask);
  EXPECT_EQ(answers[0].status, AnswerStatus::kAnswered);
  EXPECT_EQ(answers[1].status, AnswerStatus::kUnsupported);
  EXPECT_EQ(answers[1].reason, "balls only");
  EXPECT_EQ(answers[2].status, AnswerStatus::kCrashed);
  EXPECT_EQ(answers[2].reason, "threw std::runtime_error: too fat");
  EXPECT_EQ(answers[3].status, AnswerStatus::kAnswered);
  EXPECT_GT(answers[0].seconds, 0);
  EXPECT_EQ(answers[1].seconds, 0);
  EXPECT_GT(answers[2].seconds, 0);
}

}  // namespace
}  // namespace touchstone
