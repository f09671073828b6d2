#include "reports/sweep/merge.h"

#include <system_error>

#include <fmt/format.h>

namespace touchstone {
namespace {

/** Returns the blocks of all parts, which are all blocks of the sweep. */
BlockSet AllBlocks(std::span<const SweepFile> parts) {
  BlockSet all;
  for (const SweepFile& part : parts) {
    if (const auto difference = DifferenceOf(part.settings(), parts.front().settings())) {
      throw SweepFileError(fmt::format("{}: it has {}; expected the settings of {}",
                                       part.file().string(), *difference,
                                       parts.front().file().string()));
    }
    for (const auto& [first, last] : part.blocks().ranges()) {
      if (!all.Add(first, last)) {
        throw SweepFileError(
            fmt::format("{}: a block of {} to {} is in another file too; expected each "
                        "shard once",
                        part.file().string(), first, last));
      }
    }
  }
  SweepPlan plan;
  plan.series = parts.front().settings().series;
  const std::uint64_t count = BlockCount(plan);
  if (const auto missing = all.FirstMissing(count)) {
    throw SweepFileError(fmt::format(
        "block {} of {} is missing; expected every shard, complete", *missing, count));
  }
  return all;
}

/** Writes the sum of `parts`, which have the blocks `all`. */
void Write(std::span<const SweepFile> parts, const BlockSet& all,
           const std::filesystem::path& target) {
  const SweepSettings& settings = parts.front().settings();
  std::filesystem::path unfinished = target;
  unfinished += ".new";
  std::error_code error;
  std::filesystem::remove(unfinished, error);
  {
    SweepFile merged = SweepFile::Create(unfinished, settings, SweepJournal::kNone);
    for (std::size_t s = 0; s < settings.series.size(); ++s) {
      SeriesTally sum;
      for (const SweepFile& part : parts) Merge(part.Read(s), sum);
      merged.Commit({{s, std::move(sum)}}, {});
    }
    merged.Commit({}, all);
  }
  std::filesystem::rename(unfinished, target, error);
  if (error) {
    throw SweepFileError(fmt::format("{}: {}; expected a file that can be written",
                                     target.string(), error.message()));
  }
}

}  // namespace

void WritePart(const SweepFile& part, const std::filesystem::path& target) {
  Write({&part, 1}, part.blocks(), target);
}

void WriteMerged(std::span<const SweepFile> parts, const std::filesystem::path& target) {
  Write(parts, AllBlocks(parts), target);
}

}  // namespace touchstone
