#include "oracles/isolation/motion_store.h"

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "oracles/isolation/answer_wire.h"

namespace touchstone {
namespace {

// A motion of `samples` samples with numbers whose bits matter.
Trajectory Motion(int samples) {
  Trajectory motion;
  motion.status = AnswerStatus::kAnswered;
  motion.gives_impulses = true;
  for (int s = 0; s < samples; ++s) {
    motion.times.push_back(0.1 * s);
    BodyState body;
    body.p_WB = {-0.0, std::nextafter(1.0, 2.0), 1e-310 * s};
    body.q_WB = {1, 0, 0, 0};
    body.v_WB.setConstant(std::numeric_limits<double>::quiet_NaN());
    body.w_WB.setZero();
    motion.samples.push_back({.bodies = {body}, .particles = {}, .nodes = {}});
  }
  return motion;
}

TEST(MotionStore, KeepsMotionsBitForBitInAnyOrder) {
  MotionStore store;
  const std::vector<int> samples = {3, 0, 4000, 1};
  std::vector<MotionStore::Place> places;
  places.reserve(samples.size());
  for (const int count : samples) places.push_back(store.Keep(Motion(count)));
  for (const std::size_t i : {2U, 0U, 3U, 1U})
    EXPECT_EQ(ToWire(store.Take(places[i])), ToWire(Motion(samples[i]))) << i;
}

TEST(MotionStore, KeepsWhyThereIsNoMotion) {
  MotionStore store;
  Trajectory crashed;
  crashed.status = AnswerStatus::kCrashed;
  crashed.reason = "aborted";
  crashed.complaint = "LCP internal error";
  EXPECT_EQ(ToWire(store.Take(store.Keep(crashed))), ToWire(crashed));
}

TEST(MotionStore, KeepsTheMotionsOfManyThreads) {
  constexpr int kMotions = 50;
  MotionStore store;
  std::vector<std::vector<MotionStore::Place>> places(2);
  std::vector<std::jthread> threads;
  threads.reserve(places.size());
  for (std::vector<MotionStore::Place>& of_thread : places) {
    threads.emplace_back([&] {
      for (int i = 0; i < kMotions; ++i) of_thread.push_back(store.Keep(Motion(i)));
    });
  }
  threads.clear();
  for (const std::vector<MotionStore::Place>& of_thread : places) {
    for (int i = 0; i < kMotions; ++i)
      EXPECT_EQ(ToWire(store.Take(of_thread[static_cast<std::size_t>(i)])),
                ToWire(Motion(i)));
  }
}

}  // namespace
}  // namespace touchstone
