#include "oracles/isolation/answering_child.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <stdio_ext.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "oracles/isolation/last_line.h"
#include "oracles/isolation/sanitized_fork.h"

namespace touchstone {
namespace {

// The descriptor of the child's end of the pipe, whatever it was in the parent.
constexpr int kAnswersFd = 3;
// The most that a child may print to stderr on one question; more is lost. [bytes]
constexpr rlim_t kMostOutput = rlim_t{64} << 20;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif
#else
constexpr bool kLimitsMemory = true;
#endif

// Held from the creation of a pipe until the parent has closed the child's end. Otherwise
// a child forked by another thread in between would keep that end open.
std::mutex fork_mutex;

[[noreturn]] void ThrowErrno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void CloseFd(int& fd) {
  if (fd >= 0) close(fd);
  fd = -1;
}

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

// Requests a SIGPROF once this process has used `cpu` more CPU time.
void SetCpuDeadline(std::chrono::microseconds cpu) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(cpu);
  itimerval timer{};
  timer.it_value.tv_sec = seconds.count();
  timer.it_value.tv_usec = (cpu - seconds).count();
  setitimer(ITIMER_PROF, &timer, nullptr);
}

bool WriteAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(fd, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::string Seconds(std::chrono::milliseconds duration) {
  std::string text = std::to_string(static_cast<double>(duration.count()) / 1000);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

}  // namespace

AnsweringChild::AnsweringChild(std::size_t count, const Answerer& answerer,
                               const Limits& limits)
    : limits_(limits) {
  const rlim_t address_space = AddressSpace();
  AllowForkUnderSanitizer();
  const std::lock_guard lock(fork_mutex);
  output_fd_ = memfd_create("touchstone-output", MFD_CLOEXEC);
  if (output_fd_ < 0) ThrowErrno("memfd_create");
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    CloseFd(output_fd_);
    ThrowErrno("pipe2");
  }
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) {
    const int error = errno;
    for (int fd : {ends[0], ends[1], output_fd_}) CloseFd(fd);
    errno = error;
    ThrowErrno("fork");
  }
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(0);  // The parent died before the call of prctl.
    ResetSignals();
    __fpurge(stdout);  // The parent writes its own unwritten output.
    fcntl(output_fd_, F_SETFL, O_APPEND);
    // Copies first, so that no dup2 below closes a descriptor that is still needed.
    const int answers_fd = fcntl(ends[1], F_DUPFD, 64);
    const int output_fd = fcntl(output_fd_, F_DUPFD, 64);
    // Not into the file of stderr: half a buffered line would merge with an assertion.
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
    dup2(output_fd, STDERR_FILENO);
    dup2(answers_fd, kAnswersFd);
    close_range(kAnswersFd + 1, ~0U, 0);
    LowerLimit(RLIMIT_CORE, 0);
    LowerLimit(RLIMIT_FSIZE, kMostOutput);
    if (kLimitsMemory) LowerLimit(RLIMIT_AS, address_space + limits_.memory);
    Run(count, answerer);
  }
  close(ends[1]);
  answers_fd_ = ends[0];
}

AnsweringChild::~AnsweringChild() {
  if (pid_ >= 0) Kill();
  CloseFd(answers_fd_);
  CloseFd(output_fd_);
}

// The main loop of the child. Never returns, so that no object of the parent is destroyed
// twice.
void AnsweringChild::Run(std::size_t count, const Answerer& answerer) {
  for (std::size_t question = 0; question < count; ++question) {
    if (lseek(STDERR_FILENO, 0, SEEK_END) > 0 && ftruncate(STDERR_FILENO, 0) != 0)
      _exit(1);
    SetCpuDeadline(limits_.cpu);
    const std::string answer = answerer(question);
    const auto length = static_cast<std::uint64_t>(answer.size());
    std::string frame(reinterpret_cast<const char*>(&length), sizeof(length));
    frame += answer;
    if (!WriteAll(kAnswersFd, frame)) _exit(1);
  }
  _exit(0);
}

// Waits for bytes; returns false if there will be none.
bool AnsweringChild::ReadMore() {
  const auto give_up = std::chrono::steady_clock::now() + limits_.wall;
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(
        give_up - std::chrono::steady_clock::now());
    if (left.count() <= 0) {
      silence_ = Silence::kBlocked;
      return false;
    }
    pollfd waiting{answers_fd_, POLLIN, 0};
    const int ready = poll(&waiting, 1, static_cast<int>(left.count()));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    std::array<char, 1 << 16> bytes;
    const ssize_t count = read(answers_fd_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    received_.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }
}

std::optional<std::string_view> AnsweringChild::NextBytes() {
  received_.erase(0, taken_);
  taken_ = 0;
  for (;;) {
    std::uint64_t length = 0;
    if (received_.size() >= sizeof(length)) {
      std::memcpy(&length, received_.data(), sizeof(length));
      if (length > limits_.answer) {
        silence_ = Silence::kNonsense;
        return std::nullopt;
      }
      if (received_.size() - sizeof(length) >= length) {
        taken_ = sizeof(length) + length;
        return std::string_view(received_).substr(sizeof(length), length);
      }
    }
    if (!ReadMore()) return std::nullopt;
  }
}

// Kills the child and returns its wait status. Killing a dead child does not change it.
int AnsweringChild::Kill() {
  kill(pid_, SIGKILL);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

// Waits for the death of a child that has closed its pipe; returns false if it lives on.
bool AnsweringChild::IsDead() const {
  int process = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
  pollfd waiting{process, POLLIN, 0};
  int ready = 0;
  do {
    ready = poll(&waiting, 1, static_cast<int>(limits_.wall.count()));
  } while (ready < 0 && errno == EINTR);
  CloseFd(process);
  return ready > 0;
}

std::string AnsweringChild::LastLine() {
  return LastLineOf(STDERR_FILENO);
}

AnsweringChild::Ending AnsweringChild::LastWords() {
  if (silence_ == Silence::kDeath && !IsDead()) silence_ = Silence::kBlocked;
  const int status = Kill();
  const std::string line = LastLineOf(output_fd_);
  const std::string said = line.empty() ? "" : ": " + line;
  switch (silence_) {
    case Silence::kNonsense:
      return {AnswerStatus::kCrashed, "sent bytes that are not an answer" + said};
    case Silence::kBlocked:
      return {AnswerStatus::kTimedOut,
              "no answer after " + Seconds(limits_.wall) + ", blocked"};
    case Silence::kDeath:
      break;
  }
  if (WIFEXITED(status)) {
    return {AnswerStatus::kCrashed,
            "exited with status " + std::to_string(WEXITSTATUS(status)) + said};
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGPROF) {
    return {AnswerStatus::kTimedOut,
            "no answer after " + Seconds(limits_.cpu) + " of CPU time"};
  }
  if (signal == SIGABRT) return {AnswerStatus::kCrashed, "aborted" + said};
  const char* name = sigabbrev_np(signal);
  return {AnswerStatus::kCrashed,
          std::string("killed by SIG") + (name != nullptr ? name : "?") + said};
}

}  // namespace touchstone
