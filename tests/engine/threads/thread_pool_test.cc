#include "engine/threads/thread_pool.h"

#include <atomic>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "engine/threads/per_chunk.h"

namespace cookbook {
namespace {

TEST(ThreadPool, VisitsEveryIndexOnceInOrderedChunks) {
  for (const int threads : {1, 2, 3, 7}) {
    ThreadPool pool(threads);
    const ThreadPool::ParallelScope scope(pool, 1, 0);
    ASSERT_EQ(pool.chunk_count(), static_cast<std::size_t>(threads));
    for (const std::size_t count : {0UL, 1UL, 5UL, 1000UL}) {
      PerChunk<std::size_t> lists;
      lists.Clear(pool.chunk_count());
      pool.ParallelForIndexed(count, 0,
                              [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                                for (std::size_t i = begin; i < end; ++i) {
                                  lists[chunk].push_back(i);
                                }
                              });
      std::vector<std::size_t> all;
      lists.ForEach([&](std::size_t i) { all.push_back(i); });
      std::vector<std::size_t> expected(count);
      std::iota(expected.begin(), expected.end(), std::size_t{0});
      EXPECT_EQ(all, expected) << threads << " threads";
    }
  }
}

TEST(ThreadPool, ReturnsAfterAllCallsHaveReturnedHoweverManyLoops) {
  ThreadPool pool(3);
  const ThreadPool::ParallelScope scope(pool, 1, 0);
  std::vector<int> times(300, 0);  // Not atomic: no two threads share an index.
  for (int loop = 1; loop <= 2000; ++loop) {
    pool.ParallelFor(times.size(), 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++times[i];
    });
    ASSERT_EQ(times, std::vector<int>(times.size(), loop));
  }
}

TEST(ThreadPool, RunsShortLoopsAndLoopsOutsideAScopeOnTheCaller) {
  ThreadPool pool(2);
  // Neither of the two chunks ends before both have begun, so no thread runs both.
  const auto runs_in_parallel = [&](std::size_t least) {
    std::atomic<int> begun = 0;
    pool.ParallelFor(100, least, [&](std::size_t begin, std::size_t end) {
      ++begun;
      while (end - begin < 100 && begun < 2) std::this_thread::yield();
    });
    return begun == 2;
  };
  EXPECT_FALSE(runs_in_parallel(0));
  {
    const ThreadPool::ParallelScope scope(pool, 99, 100);
    EXPECT_FALSE(runs_in_parallel(0));
  }
  {
    const ThreadPool::ParallelScope scope(pool, 100, 100);
    EXPECT_FALSE(runs_in_parallel(101));
    EXPECT_TRUE(runs_in_parallel(100));
  }
  EXPECT_FALSE(runs_in_parallel(0));
}

// The thread that runs the first chunk is held up: the other threads run the other
// chunks.
TEST(ThreadPool, DoesNotWaitForAThreadThatHasBegunNothing) {
  ThreadPool pool(3);
  const ThreadPool::ParallelScope scope(pool, 1, 0);
  for (int loop = 0; loop < 100; ++loop) {
    std::atomic<int> in_first_chunk = 0;
    std::atomic<int> chunks_done = 0;
    pool.ParallelFor(3, 0, [&](std::size_t begin, std::size_t) {
      // The first chunk ends only when the others are done.
      if (begin == 0) {
        ++in_first_chunk;
        while (chunks_done < 2) std::this_thread::yield();
      }
      ++chunks_done;
    });
    ASSERT_EQ(chunks_done, 3);
    ASSERT_EQ(in_first_chunk, 1);
  }
}

}  // namespace
}  // namespace cookbook
