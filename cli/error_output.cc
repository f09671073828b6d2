#include "cli/error_output.h"

#include <csignal>

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include "cli/input_error.h"
#include "oracles/isolation/last_line.h"

namespace touchstone {

ErrorOutput::ErrorOutput() : file_(memfd_create("touchstone-error-output", MFD_CLOEXEC)) {
  if (file_ < 0)
    throw InputError("cannot create a file for the output of a child process");
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

std::string ErrorOutput::LastLine() const {
  return LastLineOf(file_);
}

}  // namespace touchstone
