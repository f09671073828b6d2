#include "oracles/isolation/child_context.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <optional>

#include <fcntl.h>
#include <stdio_ext.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include "oracles/isolation/last_line.h"
#include "oracles/isolation/sanitizers.h"

namespace touchstone {
namespace {

// The descriptors of the child's end of the socket and of the file of records, whatever
// they were in the parent.
constexpr int kSocketFd = 3;
constexpr int kRecordsFd = 4;
// The longest file: what a child may print to stderr in one task, beyond which all is
// lost, and its records. [bytes]
constexpr rlim_t kMostOutput = rlim_t{64} << 20;

// The address space in use. [bytes]
rlim_t AddressSpace() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void LowerLimit(__rlimit_resource resource, rlim_t most) {
  rlimit limit;
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, most);
  setrlimit(resource, &limit);
}

// Resets signals to their default actions, whatever the program has installed. Two kinds
// are ignored: the terminal's signals, which are for the program (the child ends with
// it), and SIGXFSZ, so that output beyond kMostOutput is only lost.
void ResetSignals() {
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS, SIGTRAP,
                           SIGPROF, SIGALRM, SIGTERM, SIGPIPE}) {
    std::signal(signal, SIG_DFL);
  }
  for (const int signal : {SIGINT, SIGQUIT, SIGHUP, SIGXFSZ})
    std::signal(signal, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void RedirectAndClose(int socket, int output, int records) {
  __fpurge(stdout);  // The parent writes its own unwritten output.
  fcntl(output, F_SETFL, O_APPEND);
  fcntl(records, F_SETFL, O_APPEND);
  // Copies first, so that no dup2 below closes a descriptor that is still needed.
  const int socket_copy = fcntl(socket, F_DUPFD, 64);
  const int output_copy = fcntl(output, F_DUPFD, 64);
  const int records_copy = fcntl(records, F_DUPFD, 64);
  // Not into the file of stderr: half a buffered line would merge with an assertion.
  dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
  dup2(output_copy, STDERR_FILENO);
  dup2(socket_copy, kSocketFd);
  dup2(records_copy, kRecordsFd);
  close_range(kRecordsFd + 1, ~0U, 0);
}

// Requests a SIGPROF once this process has used `cpu` more CPU time.
void SetCpuDeadline(std::chrono::microseconds cpu) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(cpu);
  itimerval timer{};
  timer.it_value.tv_sec = seconds.count();
  timer.it_value.tv_usec = (cpu - seconds).count();
  setitimer(ITIMER_PROF, &timer, nullptr);
}

}  // namespace

ChildContext::ChildContext(int socket, int output, int records, const ChildLimits& limits)
    : limits_(limits), socket_(UniqueFd(kSocketFd), limits.message) {
  const rlim_t address_space = AddressSpace();
  ResetSignals();
  RedirectAndClose(socket, output, records);
  LowerLimit(RLIMIT_CORE, 0);
  LowerLimit(RLIMIT_FSIZE, kMostOutput);
  if (!kSanitizerReservesMemory) LowerLimit(RLIMIT_AS, address_space + limits.memory);
}

void ChildContext::StartTask() {
  if (lseek(STDERR_FILENO, 0, SEEK_END) > 0 && ftruncate(STDERR_FILENO, 0) != 0) _exit(1);
  SetCpuDeadline(limits_.cpu);
}

void ChildContext::Send(std::string_view message) {
  if (!socket_.Send(message)) _exit(1);
}

void ChildContext::Record(std::string_view message) {
  const std::string framed = MessageSocket::Framed(message);
  for (std::string_view rest = framed; !rest.empty();) {
    const ssize_t count = write(kRecordsFd, rest.data(), rest.size());
    if (count < 0 && errno != EINTR) _exit(1);
    if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  }
  recorded_ += framed.size();
}

std::string_view ChildContext::Receive() {
  const std::optional<std::string_view> message = socket_.Receive();
  if (!message) _exit(1);
  return *message;
}

std::string ChildContext::LastLine() {
  return LastLineOf(STDERR_FILENO);
}

}  // namespace touchstone
