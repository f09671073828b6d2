#include "cli/output_folder.h"

#include <fstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/input_error.h"

namespace touchstone {
namespace {

void Make(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError(
        fmt::format("cannot create the folder {}: {}", folder.string(), error.message()));
  }
}

}  // namespace

OutputFolder::OutputFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  Make(folder_);
  if (access(folder_.c_str(), W_OK | X_OK) != 0) {
    throw InputError(fmt::format("cannot write to the folder {}", folder_.string()));
  }
}

void OutputFolder::Check(const std::filesystem::path& file) const {
  const std::filesystem::path path = folder_ / file;
  std::error_code error;  // Set for a cycle of links.
  if (!std::filesystem::exists(path, error) && !error) return;
  if (std::filesystem::is_directory(path, error) || access(path.c_str(), W_OK) != 0) {
    throw InputError(fmt::format("cannot write {}", path.string()));
  }
}

void OutputFolder::Write(const std::filesystem::path& file,
                         const std::function<void(std::ostream&)>& write) const {
  const std::filesystem::path path = folder_ / file;
  Make(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  write(out);
  out.close();
  if (!out) throw InputError(fmt::format("cannot write {}", path.string()));
}

}  // namespace touchstone
