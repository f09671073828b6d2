#include "oracles/isolation/child_process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "oracles/isolation/last_line.h"
#include "oracles/isolation/sanitized_fork.h"
#include "oracles/no_answer.h"

namespace touchstone {
namespace {

using Silence = MessageSocket::Silence;

// Held from the creation of a socket until the parent has closed the child's end.
// Without it, a child that another thread forks in between would hold that end open until
// its close_range().
std::mutex fork_mutex;

// Returns the result of a system call, which is negative if the call failed.
int Checked(int result, const char* what) {
  if (result < 0) throw std::system_error(errno, std::generic_category(), what);
  return result;
}

UniqueFd UnnamedFile(const char* name) {
  return UniqueFd(Checked(memfd_create(name, MFD_CLOEXEC), "memfd_create"));
}

// Returns the length of a file. [bytes]
std::size_t LengthOf(int fd) {
  struct stat file {};
  return fstat(fd, &file) == 0 ? static_cast<std::size_t>(file.st_size) : 0;
}

// Returns the contents of a file; nothing if it cannot be read.
std::string ContentsOf(int fd) {
  std::string bytes(LengthOf(fd), '\0');
  const ssize_t count = pread(fd, bytes.data(), bytes.size(), 0);
  return bytes.substr(0, static_cast<std::size_t>(std::max<ssize_t>(0, count)));
}

// The child. Never returns, so that no object of the parent is destroyed twice.
[[noreturn]] void RunChild(int socket, int output, int records, const ChildLimits& limits,
                           const ChildProcess::Main& main) noexcept {
  try {
    ChildContext context(socket, output, records, limits);
    main(context);
  } catch (...) {
    std::fputs(CrashedByException().reason.c_str(), stderr);
    std::abort();
  }
  _exit(0);
}

std::string Seconds(std::chrono::milliseconds duration) {
  std::string text = std::to_string(static_cast<double>(duration.count()) / 1000);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

}  // namespace

ChildProcess::ChildProcess(const ChildLimits& limits, const Main& main)
    : limits_(limits) {
  RequireThatChildrenMayStart();
  AllowForkUnderSanitizer();
  const std::lock_guard lock(fork_mutex);
  output_ = UnnamedFile("touchstone-output");
  records_ = UnnamedFile("touchstone-records");
  int ends[2];
  Checked(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), "socketpair");
  socket_ = MessageSocket(UniqueFd(ends[0]), limits.message);
  const UniqueFd childs_end(ends[1]);
  const pid_t parent = getpid();
  pid_ = Checked(fork(), "fork");
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(0);  // The parent died before the call of prctl.
    RunChild(childs_end.get(), output_.get(), records_.get(), limits, main);
  }
  living_.emplace(pid_);
}

ChildProcess::~ChildProcess() {
  Kill();
}

std::optional<std::string_view> ChildProcess::ReceiveBytes() {
  return socket_.Receive(std::chrono::steady_clock::now() + limits_.wall);
}

// Waits until the child has closed its socket, or for the limit of wall-clock time after
// it has last been seen to record anything.
void ChildProcess::AwaitRecords() {
  using Clock = std::chrono::steady_clock;
  // The wait exceeds the limit by one part at most.
  constexpr int kParts = 8;
  const auto part = std::max(limits_.wall / kParts, std::chrono::milliseconds(1));
  std::size_t length = 0;
  Clock::time_point last = Clock::now();
  while (!socket_.AwaitClosing(Clock::now() + part)) {
    const std::size_t now = LengthOf(records_.get());
    if (now != std::exchange(length, now)) {
      last = Clock::now();
    } else if (Clock::now() - last >= limits_.wall) {
      socket_.GiveUp();
      return;
    }
  }
}

std::optional<std::string_view> ChildProcess::NextRecordBytes() {
  if (!recorded_) {
    AwaitRecords();
    recorded_ = ContentsOf(records_.get());
  }
  const std::string_view rest = std::string_view(*recorded_).substr(taken_);
  std::uint64_t length = 0;
  if (rest.size() < sizeof(length)) return std::nullopt;
  std::memcpy(&length, rest.data(), sizeof(length));
  if (length > limits_.message) {
    socket_.Reject();
    return std::nullopt;
  }
  // The child died while it was writing.
  if (rest.size() - sizeof(length) < length) return std::nullopt;
  taken_ += sizeof(length) + length;
  return rest.substr(sizeof(length), length);
}

std::string ChildProcess::LastLine() const {
  return LastLineOf(output_.get());
}

// Waits for the death of a child that has closed its socket; returns false if it lives
// on. WNOWAIT leaves the status for Kill().
bool ChildProcess::IsDead() const {
  if (pid_ < 0) return true;
  const auto deadline = std::chrono::steady_clock::now() + limits_.wall;
  // Most children die at once. Some threads have hundreds of them per second.
  std::chrono::microseconds pause(10);
  do {
    siginfo_t info{};
    const int result =
        waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
    if (result == 0 && info.si_pid == pid_) return true;
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::microseconds(1000));
  } while (std::chrono::steady_clock::now() < deadline);
  return false;
}

// Kills the child and returns its wait status. Killing a dead child does not change it.
int ChildProcess::Kill() {
  if (pid_ < 0) return status_;
  kill(pid_, SIGKILL);
  living_.reset();
  while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status_;
}

ChildProcess::Ending ChildProcess::End() {
  Silence silence = socket_.silence().value_or(Silence::kClosed);
  if (silence == Silence::kClosed && !IsDead()) silence = Silence::kLate;
  const int status = Kill();
  const std::string line = LastLine();
  const std::string said = line.empty() ? "" : ": " + line;
  switch (silence) {
    case Silence::kInvalid:
      return {AnswerStatus::kCrashed, "sent bytes that are not an answer" + said};
    case Silence::kLate:
      return {AnswerStatus::kTimedOut,
              "no answer after " + Seconds(limits_.wall) + ", blocked"};
    case Silence::kClosed:
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
