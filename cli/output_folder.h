#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace touchstone {

/** A folder for results. */
class OutputFolder {
 public:
  /** Creates the folder if it does not exist. Throws InputError if that fails or if the
   folder is not writable, so that the error comes before the work. */
  explicit OutputFolder(std::filesystem::path folder);

  /** Throws InputError if `file`, relative to the folder, exists and is not writable. */
  void Check(const std::filesystem::path& file) const;

  /** Writes `file`, relative to the folder, with `write`. Creates the folder of `file` if
   needed. Throws InputError on failure. */
  void Write(const std::filesystem::path& file,
             const std::function<void(std::ostream&)>& write) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace touchstone
