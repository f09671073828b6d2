#include "cli/error_output.h"

#include <array>
#include <csignal>

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include "cli/input_error.h"

namespace touchstone {

ErrorOutput::ErrorOutput() : file_(memfd_create("touchstone-error-output", MFD_CLOEXEC)) {
  if (file_ < 0) throw InputError("no file for what a child process prints");
}

ErrorOutput::~ErrorOutput() {
  close(file_);
}

void ErrorOutput::Take() const {
  constexpr rlim_t kMost = rlim_t{64} << 20;
  const rlimit limit{kMost, kMost};
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, SIG_IGN);
  dup2(file_, STDERR_FILENO);
}

ErrorOutput::Said ErrorOutput::Read() const {
  constexpr std::size_t kMost = 200;
  Said said;
  std::string line;
  const auto end_line = [&] {
    if (line.find_first_not_of(' ') == std::string::npos) return;
    ++said.lines;
    said.last = line;
  };
  std::array<char, 1 << 16> bytes;
  off_t at = 0;
  for (ssize_t count = 0; (count = pread(file_, bytes.data(), bytes.size(), at)) > 0;
       at += count) {
    for (ssize_t i = 0; i < count; ++i) {
      const char c = bytes[static_cast<std::size_t>(i)];
      if (c == '\n') {
        end_line();
        line.clear();
      } else if (line.size() < kMost) {
        line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
      }
    }
  }
  end_line();
  return said;
}

}  // namespace touchstone
