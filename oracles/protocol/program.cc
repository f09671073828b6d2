#include "oracles/protocol/program.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "oracles/isolation/last_line.h"

namespace touchstone {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// How often the CPU time of a program that has not answered is looked at.
constexpr milliseconds kLook{250};

// How long a program may take to end after its input has been closed.
constexpr milliseconds kFarewell{1000};

// The part of the standard error that is kept. [bytes]
constexpr std::size_t kTail = 4096;

// Returns the words of /proc/PID/stat after the program's name, which may hold spaces.
std::vector<std::string> StatOf(const std::filesystem::path& process) {
  std::ifstream file(process / "stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return {};
  std::vector<std::string> words;
  std::size_t begin = name_end + 2;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

long NumberIn(const std::string& word) {
  long number = 0;
  std::from_chars(word.data(), word.data() + word.size(), number);
  return number;
}

// Returns the CPU time that the processes of a group have used, see proc(5).
milliseconds CpuTimeOf(pid_t group) {
  constexpr std::size_t kGroup = 2;
  constexpr std::size_t kFirstTime = 11;  // utime, stime, cutime, cstime
  constexpr std::size_t kLastTime = 14;
  long ticks = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::vector<std::string> words = StatOf(entry.path());
    if (words.size() <= kLastTime || NumberIn(words[kGroup]) != group) continue;
    for (std::size_t i = kFirstTime; i <= kLastTime; ++i) ticks += NumberIn(words[i]);
  }
  return milliseconds(ticks * 1000 / sysconf(_SC_CLK_TCK));
}

std::string Seconds(milliseconds duration) {
  return fmt::format("{} s", static_cast<double>(duration.count()) / 1000);
}

/** What a read has found. */
enum class Reading { kBytes, kNothing, kEnd };

// Appends what a descriptor that does not block has to offer.
Reading Read(int fd, std::string& bytes) {
  std::array<char, 1 << 16> part;
  const ssize_t count = read(fd, part.data(), part.size());
  if (count > 0) {
    bytes.append(part.data(), static_cast<std::size_t>(count));
    return Reading::kBytes;
  }
  const bool try_again = count < 0 && (errno == EAGAIN || errno == EINTR);
  return try_again ? Reading::kNothing : Reading::kEnd;
}

}  // namespace

/** One message and the wait for its answer. */
class Program::Exchange {
 public:
  Exchange(Program& program, std::string bytes, const AnswerLimits& limits)
      : program_(program), bytes_(std::move(bytes)), unsent_(bytes_), limits_(limits) {}

  Message Run() {
    while (true) {
      if (std::optional<Message> message = Complete()) return *std::move(message);
      // Only of a program that has not answered: this one may have slept itself.
      if (!Wait()) CheckTime();
    }
  }

 private:
  // Returns the answer if all of it has been received, and removes it.
  std::optional<Message> Complete() {
    std::string& received = program_.received_;
    if (!line_) {
      const std::size_t end = received.find('\n', searched_);
      searched_ = received.size();
      if (end == std::string::npos) {
        if (received.size() > limits_.line) {
          throw NoReply{AnswerStatus::kCrashed,
                        fmt::format("sent a line of more than {} bytes", limits_.line)};
        }
        return std::nullopt;
      }
      line_ = LineFrom(std::string_view(received).substr(0, end));
      frame_ = FrameSizeOf(*line_, limits_.line);
      received.erase(0, end + 1);
    }
    if (received.size() < frame_) return std::nullopt;
    Message message{*std::move(line_),
                    FrameFrom(std::string_view(received).substr(0, frame_))};
    received.erase(0, frame_);
    return message;
  }

  // Waits until there is something to do, and does it. Returns whether bytes of the
  // answer have come.
  bool Wait() {
    const StartedProgram& streams = program_.started_;
    std::array<pollfd, 3> waiting = {
        pollfd{streams.output.get(), POLLIN, 0},
        pollfd{streams.messages.get(), POLLIN, 0},
        pollfd{unsent_.empty() ? -1 : streams.input.get(), POLLOUT, 0}};
    const int ready =
        poll(waiting.data(), waiting.size(), static_cast<int>(kLook.count()));
    if (ready <= 0) return false;
    if (waiting[2].revents != 0) Send();
    if (waiting[1].revents != 0) program_.ReadMessages();
    if (waiting[0].revents == 0) return false;
    const Reading reading = Read(streams.output.get(), program_.received_);
    if (reading == Reading::kEnd) throw program_.Ended();
    // An answer that never ends keeps nobody from looking at the clock.
    return reading == Reading::kBytes && Clock::now() < next_look_;
  }

  void Send() {
    const ssize_t count =
        send(program_.started_.input.get(), unsent_.data(), unsent_.size(), MSG_NOSIGNAL);
    if (count >= 0) {
      unsent_.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EAGAIN && errno != EINTR) {
      unsent_ = {};  // It reads no more, and may still have answered.
    }
  }

  void CheckTime() {
    const Clock::time_point now = Clock::now();
    if (now - begin_ > limits_.wall) {
      throw NoReply{AnswerStatus::kTimedOut,
                    fmt::format("no answer after {}, blocked", Seconds(limits_.wall))};
    }
    if (now < next_look_) return;
    next_look_ = now + kLook;
    const milliseconds cpu = CpuTimeOf(program_.started_.pid);
    if (!cpu_at_begin_) cpu_at_begin_ = cpu;
    if (cpu - *cpu_at_begin_ <= limits_.cpu) return;
    throw NoReply{AnswerStatus::kTimedOut,
                  fmt::format("no answer after {} of CPU time", Seconds(limits_.cpu))};
  }

  Program& program_;
  std::string bytes_;
  std::string_view unsent_;
  AnswerLimits limits_;
  std::size_t searched_ = 0;  // Bytes of the answer known to hold no end of a line.
  std::optional<Json> line_;
  std::size_t frame_ = 0;  // Size of the frame after `line_`. [bytes]
  Clock::time_point begin_ = Clock::now();
  // Most answers come sooner than the first look, which then costs nothing.
  Clock::time_point next_look_ = begin_ + kLook;
  std::optional<milliseconds> cpu_at_begin_;
};

Program::~Program() {
  const std::string_view bye = "{\"method\":\"bye\"}\n";
  send(started_.input.get(), bye.data(), bye.size(), MSG_NOSIGNAL);
  started_.input.Reset();
  if (!failed_) AwaitEnd();
  // Before it is waited for: after that, its number may be that of another group.
  kill(-started_.pid, SIGKILL);
  living_.reset();
  while (waitpid(started_.pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

// Waits for a moment until the program has ended, and returns how; nothing if it lives
// on. WNOWAIT leaves it to the destructor to wait for it.
std::optional<siginfo_t> Program::AwaitEnd() const {
  const Clock::time_point deadline = Clock::now() + kFarewell;
  do {
    siginfo_t info{};
    const int result = waitid(P_PID, static_cast<id_t>(started_.pid), &info,
                              WEXITED | WNOHANG | WNOWAIT);
    if (result == 0 && info.si_pid == started_.pid) return info;
    std::this_thread::sleep_for(milliseconds(1));
  } while (Clock::now() < deadline);
  return std::nullopt;
}

Message Program::Ask(Message message, const AnswerLimits& limits) {
  const int id = next_id_++;
  Json line = {{"id", id}};
  line.update(message.line);
  message.line = std::move(line);
  ReadMessages();
  tail_.clear();
  try {
    Message answer = Exchange(*this, BytesOf(std::move(message)), limits).Run();
    ReadMessages();
    const auto found = answer.line.find("id");
    if (found == answer.line.end() || *found != id) {
      throw ProtocolError(fmt::format(
          "answered with the id {}; expected {}, that of the message",
          found == answer.line.end() ? std::string("missing") : OneLine(*found), id));
    }
    return answer;
  } catch (const ProtocolError& error) {
    failed_ = true;
    throw NoReply{AnswerStatus::kCrashed, error.what()};
  } catch (const NoReply&) {
    failed_ = true;
    throw;
  }
}

std::string Program::LastLine() const {
  return LastLineIn(tail_);
}

void Program::ReadMessages() {
  // A program that never stops writing gets no more attention than this at once.
  constexpr int kMost = 64;
  Reading reading = Reading::kBytes;
  for (int i = 0; i < kMost && reading == Reading::kBytes; ++i) {
    reading = Read(started_.messages.get(), tail_);
    if (tail_.size() > kTail) tail_.erase(0, tail_.size() - kTail);
  }
  // Closed by the program; an end would wake every poll() from now on.
  if (reading == Reading::kEnd) started_.messages.Reset();
}

// Returns how the program ended that has closed its output.
NoReply Program::Ended() {
  const std::optional<siginfo_t> end = AwaitEnd();
  ReadMessages();
  const std::string line = LastLine();
  const std::string said = line.empty() ? "" : ": " + line;
  if (!end) return {AnswerStatus::kCrashed, "closed its standard output" + said};
  if (end->si_code == CLD_EXITED) {
    return {AnswerStatus::kCrashed,
            fmt::format("exited with status {}{}", end->si_status, said)};
  }
  if (end->si_status == SIGABRT) return {AnswerStatus::kCrashed, "aborted" + said};
  const char* name = sigabbrev_np(end->si_status);
  return {AnswerStatus::kCrashed,
          fmt::format("killed by SIG{}{}", name != nullptr ? name : "?", said)};
}

}  // namespace touchstone
