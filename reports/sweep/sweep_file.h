#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/sweep/block_set.h"
#include "reports/sweep/database.h"
#include "reports/sweep/sweep_settings.h"
#include "reports/sweep/tally.h"

namespace touchstone {

/** The version of the tables, which docs/sweep_file.md documents. */
inline constexpr int kSweepSchema = 6;

/** The way in which a file is written. */
enum class SweepJournal {
  /** A write-ahead log, held exclusively: whatever kills the process, the file has every
   commit that ended. Needs no shared memory, so the file may lie on a network. */
  kLog,
  kNone,  ///< For a file that nobody reads before it is complete.
};

/** The results of a sweep in an SQLite file. Every function throws SweepFileError. */
class SweepFile {
 public:
  /** Creates a file without blocks. ":memory:" is a file in memory.
   @pre The file does not exist, or is a database without tables. */
  static SweepFile Create(const std::filesystem::path& file,
                          const SweepSettings& settings, SweepJournal journal);

  /** Opens the file of an unfinished sweep, or creates it with a log. Throws if it has
   other settings. */
  static SweepFile Resume(const std::filesystem::path& file,
                          const SweepSettings& settings);

  /** Opens an existing file and checks that it is one of this schema, and intact. */
  static SweepFile Open(const std::filesystem::path& file);

  /** Throws if the file has other settings. */
  void Require(const SweepSettings& settings) const;

  const std::filesystem::path& file() const { return database_.file(); }
  const SweepSettings& settings() const { return settings_; }
  const BlockSet& blocks() const { return blocks_; }

  /** Returns the results of one series. */
  SeriesTally Read(std::size_t series) const;

  /** Replaces the results of `series` and adds `blocks`, all or nothing.
   @pre None of `blocks` is in the file. */
  void Commit(const std::map<std::size_t, SeriesTally>& series, const BlockSet& blocks);

 private:
  explicit SweepFile(Database database) : database_(std::move(database)) {}

  void ReadSettings();
  void ReadBlocks();

  Database database_;
  SweepSettings settings_;
  BlockSet blocks_;
};

}  // namespace touchstone
