#include "reports/sweep/sweep.h"

#include <utility>

namespace touchstone {
namespace {

using Clock = std::chrono::steady_clock;

/** A commit writes the whole sum of the series in progress, a hundred thousand rows for
 all engines. The next waits for fifty times as long as it took, so that commits take
 a fiftieth of the time. */
constexpr int kCommitPause = 50;

/** The results that are not in the file yet. */
class Uncommitted {
 public:
  explicit Uncommitted(SweepFile& file) : file_(file), last_(Clock::now()) {}

  void Add(std::size_t series, std::uint64_t block, const SeriesTally& result) {
    auto found = series_.find(series);
    if (found == series_.end()) found = series_.emplace(series, file_.Read(series)).first;
    Merge(result, found->second);
    blocks_.Add(block, block);
  }

  /** Commits if `time` has passed since the last commit, and kCommitPause times the
   duration of that one. */
  void CommitAfter(std::chrono::milliseconds time) {
    const Clock::duration since = Clock::now() - last_;
    if (since < time || since < kCommitPause * took_) return;
    Commit();
    // Blocks come in ascending order, or nearly so: earlier series seldom come again.
    while (series_.size() > 1) series_.erase(series_.begin());
  }

  void Commit() {
    const Clock::time_point begin = Clock::now();
    if (blocks_.size() > 0) file_.Commit(series_, blocks_);
    blocks_ = {};
    last_ = Clock::now();
    took_ = last_ - begin;
  }

 private:
  SweepFile& file_;
  std::map<std::size_t, SeriesTally> series_;  ///< Sums of all blocks so far.
  BlockSet blocks_;
  Clock::time_point last_;
  Clock::duration took_{};  ///< Duration of the last commit.
};

}  // namespace

bool Sweep(const SweepPlan& plan, SweepFile& file, const SweepOptions& options) {
  // A copy: the file's own set grows at each commit, while threads ask for it.
  const BlockSet before = file.blocks();
  std::uint64_t total = 0;
  std::uint64_t done = 0;
  const std::uint64_t blocks = BlockCount(plan);
  for (std::uint64_t b = options.shard.index; b < blocks; b += options.shard.count) {
    const std::uint64_t count = CountOf(BlockOf(plan, b).questions);
    total += count;
    if (before.Contains(b)) done += count;
  }
  BlockOptions block_options{
      .jobs = options.jobs,
      .shard = options.shard,
      .is_done = [&before](std::uint64_t b) { return before.Contains(b); },
      .stop = options.stop};
  Uncommitted uncommitted(file);
  if (options.on_progress) options.on_progress(done, total);
  RunBlocks(plan, block_options, [&](std::uint64_t block, const SeriesTally& result) {
    uncommitted.Add(BlockOf(plan, block).series, block, result);
    uncommitted.CommitAfter(options.commit_after);
    done += CountOf(BlockOf(plan, block).questions);
    if (options.on_progress) options.on_progress(done, total);
  });
  uncommitted.Commit();
  return done == total;
}

}  // namespace touchstone
