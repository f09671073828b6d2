#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>

#include <gtest/gtest.h>

#include "engine/dynamics/world/cloth.h"
#include "engine/dynamics/world/world.h"
#include "tests/engine/on_target.h"

namespace {

std::atomic<int> allocations = 0;

}  // namespace

// Counts the allocations of the program. Not inline: g++ 12 would report a mismatch of
// free() in one and malloc() in the other. NOLINTBEGIN(*-no-malloc)
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) {
    return memory;
  }
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t,
                                       std::align_val_t) noexcept {
  std::free(memory);
}
// NOLINTEND(*-no-malloc)

namespace cookbook {
namespace {

BodyDefinition MakeFloor() {
  BodyDefinition floor;
  floor.shape = Box{{50, 1, 50}};
  floor.state.p_WB = {0, -1, 0};
  floor.mass = 0;
  floor.restitution = 1;
  return floor;
}

/** Adds piles of boxes and spheres that fall on a floor. */
void Fill(World& world, int piles = 1) {
  world.AddBody(MakeFloor());
  for (int k = 0; k < 125 * piles; ++k) {
    const int i = k % 125;
    BodyDefinition body;
    if (i % 3 == 0) {
      body.shape = Sphere{0.5};
    } else {
      body.shape = Box{{0.5, 0.4, 0.45}};
    }
    body.restitution = 0.1;
    const double tilt = 0.03 * (i % 7);
    const int pile = k / 125;
    const int layer = i / 25;
    const int row = i / 5 % 5;
    body.state.p_WB = {10.0 * pile + 1.1 * (i % 5) + tilt, 0.6 + 1.05 * layer, 1.1 * row};
    body.state.q_WB = Eigen::Quaterniond(1, tilt, 0.1 - tilt, 0.02).normalized();
    world.AddBody(body);
  }
}

void ExpectSameBits(const World& a, const World& b) {
  for (int i = 0; i < a.body_count(); ++i) {
    EXPECT_EQ(a.state(i).p_WB, b.state(i).p_WB) << i;
    EXPECT_EQ(a.state(i).q_WB.coeffs(), b.state(i).q_WB.coeffs()) << i;
    EXPECT_EQ(a.state(i).v_WB, b.state(i).v_WB) << i;
    EXPECT_EQ(a.state(i).w_WB, b.state(i).w_WB) << i;
  }
}

void ExpectSameBitsForAnyNumberOfThreads(int piles, int steps) {
  Settings settings;
  World one(settings);
  settings.threads = 2;
  World two(settings);
  settings.threads = 5;
  World five(settings);
  for (World* world : {&one, &two, &five}) {
    Fill(*world, piles);
    for (int k = 0; k < steps; ++k) world->Step(1.0 / 120);
  }
  ExpectSameBits(one, two);
  ExpectSameBits(one, five);
}

// Threads solve the colours of one island together.
TEST(Repeatability, OneIslandHasTheSameBitsForAnyNumberOfThreads) {
  ExpectSameBitsForAnyNumberOfThreads(1, 120);
}

// Threads solve different islands: 1,000 bodies have about 4,000 contacts, which are
// solved in groups. Broad phase, free flight and times of impact run in parallel too.
TEST(Repeatability, ManyIslandsHaveTheSameBitsForAnyNumberOfThreads) {
  ExpectSameBitsForAnyNumberOfThreads(8, 60);
}

using RepeatabilityOnTarget = test::OnTarget;

void ExpectBitsOfTheWidestVectors(const Settings& settings, int piles, int steps,
                                  const std::function<void()>& widen) {
  World narrow(settings);
  Fill(narrow, piles);
  for (int k = 0; k < steps; ++k) narrow.Step(1.0 / 120);
  widen();
  World wide(settings);
  Fill(wide, piles);
  for (int k = 0; k < steps; ++k) wide.Step(1.0 / 120);
  ExpectSameBits(narrow, wide);
}

// Bodies fall, hit, slide and rest, so that every kernel of a step runs.
TEST_P(RepeatabilityOnTarget, APileHasTheBitsOfTheWidestVectors) {
  ExpectBitsOfTheWidestVectors({}, 1, 120, [] { Choose(kAll); });
}

// Sixteen floats at once, or twice eight, depending on the target.
TEST_P(RepeatabilityOnTarget, SinglePrecisionHasTheBitsOfTheWidestVectors) {
  Settings settings;
  settings.iteration_budget = 0;
  ExpectBitsOfTheWidestVectors(settings, 2, 90, [] { Choose(kAll); });
}

INSTANTIATE_TEST_SUITE_P(Targets, RepeatabilityOnTarget,
                         testing::ValuesIn(test::Targets()), test::NameOfTarget);

TEST(Repeatability, AStepAllocatesNothingOnceWarm) {
  World pile;
  Fill(pile);
  Settings settings;
  settings.threads = 2;
  World shared(settings);
  Fill(shared);
  World net;
  Cloth cloth;
  cloth.structural.stiffness = 50;
  cloth.pinned = {{0, 0}};
  AddCloth(cloth, net);
  World bouncing;
  bouncing.AddBody(MakeFloor());
  for (int i = 0; i < 9; ++i) {
    BodyDefinition ball;
    ball.restitution = 1;
    ball.state.p_WB = {1.1 * i, 1 + 0.3 * i, 0};
    bouncing.AddBody(ball);
  }
  // The last body falls from the pile after ten seconds. Until then the numbers of
  // neighbours and of simultaneous impacts grow.
  for (World* world : {&pile, &shared, &net, &bouncing}) {
    for (int k = 0; k < 1300; ++k) world->Step(1.0 / 120);
  }
  const int before = allocations;
  for (World* world : {&pile, &shared, &net, &bouncing}) {
    for (int k = 0; k < 60; ++k) world->Step(1.0 / 120);
  }
  EXPECT_EQ(allocations, before);
  EXPECT_GT(allocations, 0);
}

TEST(Repeatability, AWorldThatHasDivergedReportsItAndStaysUnchanged) {
  World world;
  BodyDefinition ball;
  ball.force_W = {1e300, 0, 0};
  world.AddBody(ball);
  world.Step(1.0 / 240);
  ASSERT_TRUE(world.diverged());
  const Eigen::Vector3d p = world.state(0).p_WB;
  world.Step(1.0 / 240);
  EXPECT_TRUE(world.diverged());
  EXPECT_EQ(world.state(0).p_WB, p);
}

}  // namespace
}  // namespace cookbook
