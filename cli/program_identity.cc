#include "cli/program_identity.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <link.h>

#include "reports/text/fnv_1a.h"

namespace touchstone {
namespace {

/** Called by dl_iterate_phdr() for each loaded library. */
int TakeLibrary(dl_phdr_info* library, std::size_t, void* hash) {
  std::error_code ignored;
  const std::filesystem::path file = library->dlpi_name;
  if (file.empty()) return 0;
  static_cast<Fnv1a*>(hash)->Take(fmt::format(
      "{} {} {}\n", file.string(), std::filesystem::file_size(file, ignored),
      std::filesystem::last_write_time(file, ignored).time_since_epoch().count()));
  return 0;
}

}  // namespace

std::string ProgramIdentity() {
  Fnv1a hash;
  dl_iterate_phdr(TakeLibrary, &hash);
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::string block(std::size_t{1} << 16, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) ||
         file.gcount() > 0) {
    hash.Take(std::string_view(block).substr(0, static_cast<std::size_t>(file.gcount())));
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace touchstone
