#include "cli/interrupt.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>

#include "oracles/isolation/living_child.h"

namespace touchstone {
namespace {

// The signal of the request, and its time in milliseconds.
std::atomic<int> received = 0;
std::atomic<long long> received_at = 0;
std::atomic<bool> ends_engines = false;
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<int>::is_always_lock_free);
static_assert(std::atomic<long long>::is_always_lock_free);

/** A repetition within this time belongs to the same request: timeout(1) sends its signal
 to the process and then to the group of the process. [ms] */
constexpr long long kSameRequest = 500;

long long Now() {
  std::timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);  // Allowed in a signal handler by POSIX.
  return 1000LL * now.tv_sec + now.tv_nsec / 1'000'000;
}

void Receive(int signal) {
  const int error = errno;  // Of the function that was interrupted.
  if (received == 0) {
    received_at = Now();
    received = signal;  // Before a child ends: nobody takes its end for a crash.
    if (ends_engines) EndChildren();
  } else if (Now() - received_at > kSameRequest) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // Delivered at the return from this handler.
  }
  errno = error;
}

}  // namespace

Interrupt::Interrupt(WorkingEngines engines) {
  received = 0;
  ends_engines = engines == WorkingEngines::kEnd;
  std::signal(SIGINT, Receive);
  std::signal(SIGTERM, Receive);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

int Interrupt::signal() {
  return received;
}

}  // namespace touchstone
