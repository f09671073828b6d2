#include "oracles/isolation/answer_wire.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

using Eigen::Vector3d;

// An answer with every field set, to values whose bits matter.
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
  answer.seconds = 1e-7;
  return answer;
}

// Compares bits, because == treats -0.0 as 0.0 and fails for NaN.
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
  EXPECT_EQ(received->seconds, sent.seconds);
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

// Accepted bytes must be exactly those that ToWire() writes for the result. So nothing is
// invented, nothing is read past the end (the sanitizers watch this), and no length in
// the bytes is trusted.
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

Trajectory FullTrajectory() {
  Trajectory trajectory;
  trajectory.status = AnswerStatus::kAnswered;
  trajectory.reason = "as it were";
  trajectory.complaint = "LCP internal error";
  trajectory.gives_impulses = true;
  trajectory.diverged_at_step = 7;
  trajectory.seconds = 0.3;
  for (int i = 0; i < 3; ++i) {
    const double t = 0.1 * i;
    trajectory.times.push_back(t);
    WorldState& state = trajectory.samples.emplace_back();
    state.bodies = {
        {Vector3d(t, -0.0, 1e-310),
         Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5),
         {1, 2, t},
         {std::numeric_limits<double>::infinity(), 4, 5}},
        {Vector3d(6, 7, 8), Eigen::Quaterniond(1, 0, 0, t), {9, 1, 2}, {3, 4, 5}}};
    state.particles = {{{t, 1, 2}, {3, 4, 5}}};
    state.nodes = {{{5, 4, t}, {2, 1, 0}}, {{7, t, 8}, {9, 1, 0}}};
  }
  trajectory.impulses = {
      {2, 0, 1, {1, 2, 3}, {0, 0, 1}, {4, -0.0, 6}, -1e-3, {0.6, -0.0, 0.8}},
      {3, 1, 0, {3, 2, 1}, {0, 1, 0}, {6, 5, 4}, 0}};
  return trajectory;
}

TEST(TrajectoryWire, KeepsEveryFieldBitForBit) {
  const Trajectory sent = FullTrajectory();
  const auto received = TrajectoryFromWire(ToWire(sent));
  ASSERT_TRUE(received);
  EXPECT_EQ(received->status, sent.status);
  EXPECT_EQ(received->reason, sent.reason);
  EXPECT_EQ(received->complaint, sent.complaint);
  EXPECT_EQ(received->times, sent.times);
  EXPECT_TRUE(received->gives_impulses);
  EXPECT_EQ(received->diverged_at_step, 7);
  EXPECT_EQ(received->seconds, 0.3);
  ASSERT_EQ(received->samples.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const WorldState& a = received->samples[i];
    const WorldState& b = sent.samples[i];
    ASSERT_EQ(a.bodies.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_TRUE(SameBits(a.bodies[k].p_WB, b.bodies[k].p_WB));
      EXPECT_EQ(a.bodies[k].q_WB.coeffs(), b.bodies[k].q_WB.coeffs());
      EXPECT_TRUE(SameBits(a.bodies[k].v_WB, b.bodies[k].v_WB));
      EXPECT_TRUE(SameBits(a.bodies[k].w_WB, b.bodies[k].w_WB));
    }
    ASSERT_EQ(a.particles.size(), 1u);
    EXPECT_TRUE(SameBits(a.particles[0].p_W, b.particles[0].p_W));
    EXPECT_TRUE(SameBits(a.particles[0].v_W, b.particles[0].v_W));
    ASSERT_EQ(a.nodes.size(), 2u);
    EXPECT_TRUE(SameBits(a.nodes[1].p_W, b.nodes[1].p_W));
    EXPECT_TRUE(SameBits(a.nodes[1].v_W, b.nodes[1].v_W));
  }
  ASSERT_EQ(received->impulses.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const ContactImpulse& a = received->impulses[i];
    const ContactImpulse& b = sent.impulses[i];
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.A, b.A);
    EXPECT_EQ(a.B, b.B);
    EXPECT_TRUE(SameBits(a.p_WC, b.p_WC));
    EXPECT_TRUE(SameBits(a.n_AB_W, b.n_AB_W));
    EXPECT_TRUE(SameBits(a.J_B_W, b.J_B_W));
    EXPECT_EQ(a.separation, b.separation);
    EXPECT_TRUE(SameBits(a.t_W, b.t_W));
  }
}

TEST(TrajectoryWire, RefusesEveryTruncationAndEveryExtraByte) {
  const std::string bytes = ToWire(FullTrajectory());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(TrajectoryFromWire(std::string_view(bytes).substr(0, length))) << length;
  }
  EXPECT_FALSE(TrajectoryFromWire(bytes + '\0'));
}

// The same property as for contact answers.
TEST(TrajectoryWire, SurvivesAnyBytes) {
  std::mt19937_64 random(100);
  const std::string sound = ToWire(FullTrajectory());
  int accepted = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes = sound;
    for (int k = 0; k < 3; ++k)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    bytes.resize(random() % 8 == 0 ? random() % bytes.size() : bytes.size());
    if (const auto trajectory = TrajectoryFromWire(bytes)) {
      EXPECT_EQ(ToWire(*trajectory), bytes);
      ++accepted;
    }
  }
  EXPECT_GT(accepted, 1000);
}

}  // namespace
}  // namespace touchstone
