#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace touchstone {

/** A folder that results are written to. */
class OutputFolder {
 public:
  /** Makes the folder if it is not there. Throws InputError where that fails or where it
   cannot be written to: before the work whose results it is for. */
  explicit OutputFolder(std::filesystem::path folder);

  /** Throws InputError where `file`, relative to the folder, is there and cannot be
   written. */
  void Check(const std::filesystem::path& file) const;

  /** Writes `file`, relative to the folder, by `write`, making its own folder too. Throws
   InputError where that fails. */
  void Write(const std::filesystem::path& file,
             const std::function<void(std::ostream&)>& write) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace touchstone
