#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "reports/sweep/database.h"
#include "reports/worlds/study/examine_world.h"

namespace touchstone {

/** The judged worlds of a run in an SQLite file, kept as they are judged, so that a run
 that was interrupted goes on. A result is found by the whole text of its world and by the
 name, version and settings of its oracle: an edited scenario is judged again, and no
 result is taken for another. All functions but the constructor are thread safe, and throw
 SweepFileError if the file cannot be written. */
class RunJournal {
 public:
  /** Opens `file`, or creates it. Results of another `build` of the program are removed:
   its laws may have changed. */
  RunJournal(std::filesystem::path file, const std::string& build);

  /** Returns the number of results. */
  std::size_t size() const;

  std::optional<Examination> Find(const WorldScenario& scenario,
                                  const OracleInfo& oracle) const;

  void Keep(const WorldScenario& scenario, const OracleInfo& oracle,
            const Examination& examination);

  /** Removes all results. */
  void Clear();

  /** Closes and removes the file. No other function may be called afterwards. */
  void Remove();

 private:
  mutable std::mutex using_;
  std::optional<Database> database_;
};

}  // namespace touchstone
