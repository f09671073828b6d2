#include "engine/dynamics/crew.h"

#include <atomic>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "engine/dynamics/findings.h"

namespace cookbook {
namespace {

TEST(Crew, DoesEveryIndexOnceInSharesThatFollowEachOther) {
  for (const int threads : {1, 2, 3, 7}) {
    Crew crew(threads);
    const Crew::Shift shift(crew, 1, 0);
    ASSERT_EQ(crew.shares(), static_cast<std::size_t>(threads));
    for (const std::size_t count : {0, 1, 5, 1000}) {
      Findings<std::size_t> found;
      found.Clear(crew.shares());
      crew.ShareOut(count, 0, [&](std::size_t share, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          found.Of(share).push_back(i);
        }
      });
      std::vector<std::size_t> all;
      found.ForEach([&](std::size_t i) { all.push_back(i); });
      std::vector<std::size_t> expected(count);
      std::iota(expected.begin(), expected.end(), std::size_t{0});
      EXPECT_EQ(all, expected) << threads << " threads";
    }
  }
}

TEST(Crew, ReturnsWhenAllHaveReturnedHoweverManyTasks) {
  Crew crew(3);
  const Crew::Shift shift(crew, 1, 0);
  std::vector<int> times(300, 0);  // Plain: no two threads have an index in common.
  for (int task = 1; task <= 2000; ++task) {
    crew.Share(times.size(), 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++times[i];
    });
    ASSERT_EQ(times, std::vector<int>(times.size(), task));
  }
}

TEST(Crew, TheCallerDoesAloneWhatIsTooLittleOrOutsideAShift) {
  Crew crew(4);
  const std::thread::id caller = std::this_thread::get_id();
  const auto others_help = [&](std::size_t least) {
    std::atomic<bool> helped = false;
    crew.Share(100, least, [&](std::size_t, std::size_t) {
      if (std::this_thread::get_id() != caller) helped = true;
    });
    return helped.load();
  };
  EXPECT_FALSE(others_help(0));
  {
    const Crew::Shift shift(crew, 99, 100);
    EXPECT_FALSE(others_help(0));
  }
  {
    const Crew::Shift shift(crew, 100, 100);
    EXPECT_FALSE(others_help(101));
    EXPECT_TRUE(others_help(100));
  }
  EXPECT_FALSE(others_help(0));
}

}  // namespace
}  // namespace cookbook
