#include "cli/program_identity.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <link.h>

namespace touchstone {
namespace {

/** FNV-1a, 64 bits. */
class Hash {
 public:
  void Take(std::string_view bytes) {
    for (const char byte : bytes) {
      value_ ^= static_cast<unsigned char>(byte);
      value_ *= 1099511628211U;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};

/** Called by dl_iterate_phdr() for each loaded library. */
int TakeLibrary(dl_phdr_info* library, std::size_t, void* hash) {
  std::error_code ignored;
  const std::filesystem::path file = library->dlpi_name;
  if (file.empty()) return 0;
  static_cast<Hash*>(hash)->Take(fmt::format(
      "{} {} {}\n", file.string(), std::filesystem::file_size(file, ignored),
      std::filesystem::last_write_time(file, ignored).time_since_epoch().count()));
  return 0;
}

}  // namespace

std::string ProgramIdentity() {
  Hash hash;
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
