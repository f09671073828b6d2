#include "engine/threads/thread_pool.h"

#include <atomic>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "engine/threads/per_thread.h"

namespace cookbook {
namespace {

TEST(ThreadPool, DoesEveryIndexOnceInSharesThatFollowEachOther) {
  for (const int threads : {1, 2, 3, 7}) {
    ThreadPool pool(threads);
    const ThreadPool::ParallelScope shift(pool, 1, 0);
    ASSERT_EQ(pool.shares(), static_cast<std::size_t>(threads));
    for (const std::size_t count : {0UL, 1UL, 5UL, 1000UL}) {
      PerThread<std::size_t> found;
      found.Clear(pool.shares());
      pool.ParallelForIndexed(count, 0,
                              [&](std::size_t share, std::size_t begin, std::size_t end) {
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

TEST(ThreadPool, ReturnsWhenAllHaveReturnedHoweverManyTasks) {
  ThreadPool pool(3);
  const ThreadPool::ParallelScope shift(pool, 1, 0);
  std::vector<int> times(300, 0);  // Plain: no two threads have an index in common.
  for (int task = 1; task <= 2000; ++task) {
    pool.ParallelFor(times.size(), 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++times[i];
    });
    ASSERT_EQ(times, std::vector<int>(times.size(), task));
  }
}

TEST(ThreadPool, TheCallerDoesAloneWhatIsTooLittleOrOutsideAShift) {
  ThreadPool pool(2);
  // Of two shares neither ends before both have begun, so that nobody does both.
  const auto another_helps = [&](std::size_t least) {
    std::atomic<int> begun = 0;
    pool.ParallelFor(100, least, [&](std::size_t begin, std::size_t end) {
      ++begun;
      while (end - begin < 100 && begun < 2) std::this_thread::yield();
    });
    return begun == 2;
  };
  EXPECT_FALSE(another_helps(0));
  {
    const ThreadPool::ParallelScope shift(pool, 99, 100);
    EXPECT_FALSE(another_helps(0));
  }
  {
    const ThreadPool::ParallelScope shift(pool, 100, 100);
    EXPECT_FALSE(another_helps(101));
    EXPECT_TRUE(another_helps(100));
  }
  EXPECT_FALSE(another_helps(0));
}

// One of two threads is kept from its share: the other does all.
TEST(ThreadPool, WaitsForNoThreadThatHasBegunNothing) {
  ThreadPool pool(3);
  const ThreadPool::ParallelScope shift(pool, 1, 0);
  for (int task = 0; task < 100; ++task) {
    std::atomic<int> in_first = 0;
    std::atomic<int> shares = 0;
    pool.ParallelFor(3, 0, [&](std::size_t begin, std::size_t) {
      // Whoever does the first share ends it only when the others are done.
      if (begin == 0) {
        ++in_first;
        while (shares < 2) std::this_thread::yield();
      }
      ++shares;
    });
    ASSERT_EQ(shares, 3);
    ASSERT_EQ(in_first, 1);
  }
}

}  // namespace
}  // namespace cookbook
