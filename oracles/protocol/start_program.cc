#include "oracles/protocol/start_program.h"

#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <future>
#include <mutex>
#include <stop_token>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "oracles/isolation/living_child.h"
#include "oracles/isolation/sanitized_fork.h"

namespace touchstone {
namespace {

int Checked(int result, const char* what) {
  if (result < 0) throw std::system_error(errno, std::generic_category(), what);
  return result;
}

void DoNotBlock(int fd) {
  Checked(fcntl(fd, F_SETFL, O_NONBLOCK), "fcntl");
}

/** The two ends of a pipe or a socket. */
struct Ends {
  UniqueFd ours;
  UniqueFd theirs;
};

Ends Socket() {
  int ends[2];
  Checked(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), "socketpair");
  DoNotBlock(ends[0]);
  return {UniqueFd(ends[0]), UniqueFd(ends[1])};
}

Ends Pipe() {
  int ends[2];
  Checked(pipe2(ends, O_CLOEXEC), "pipe2");
  DoNotBlock(ends[0]);
  return {UniqueFd(ends[0]), UniqueFd(ends[1])};
}

// This process's environment, with one thread for libraries that start one per core.
std::vector<std::string> Environment() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable)
    variables.emplace_back(*variable);
  for (const char* name :
       {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"}) {
    if (std::getenv(name) == nullptr) variables.push_back(std::string(name) + "=1");
  }
  return variables;
}

// The command as the shell gets it. A single program takes the place of the shell, whose
// own messages and exit status would otherwise hide how it ended.
std::string LineFor(const std::string& command) {
  const std::string first_word = command.substr(0, command.find(' '));
  const bool is_single = command.find_first_of(";&|<>()\n") == std::string::npos &&
                         first_word.find('=') == std::string::npos &&
                         first_word != "exec" && first_word != "cd";
  return is_single ? "exec " + command : command;
}

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// The new process, up to its program. Other threads of the parent may have held locks at
// the fork, so only functions that are safe in a signal handler are called.
[[noreturn]] void Become(const char* folder, char* const* arguments,
                         char* const* environment, int input, int output, int messages) {
  setpgid(0, 0);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE})
    std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
      dup2(messages, STDERR_FILENO) >= 0 && chdir(folder) == 0) {
    close_range(STDERR_FILENO + 1, ~0U, 0);
    execve(arguments[0], arguments, environment);
  }
  const std::string_view problem = "cannot be started: the folder does not exist\n";
  [[maybe_unused]] const ssize_t written =
      write(STDERR_FILENO, problem.data(), problem.size());
  _exit(127);
}

/** A thread that starts programs and lives as long as this process: the kernel kills a
 program when the thread that started it ends (PR_SET_PDEATHSIG), not the process. */
class Starter {
 public:
  /** Calls `fork_it` on the thread, and returns its result. */
  template <typename Fork>
  pid_t Run(Fork fork_it) {
    std::packaged_task<pid_t()> task(std::move(fork_it));
    std::future<pid_t> pid = task.get_future();
    {
      const std::lock_guard lock(mutex_);
      tasks_.push_back(std::move(task));
    }
    changed_.notify_one();
    return pid.get();
  }

 private:
  void Work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return !tasks_.empty(); })) {
      std::packaged_task<pid_t()> task = std::move(tasks_.front());
      tasks_.pop_front();
      lock.unlock();
      task();
      lock.lock();
    }
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<std::packaged_task<pid_t()>> tasks_;
  // Last, so that it ends before the members that it uses.
  std::jthread thread_{[this](const std::stop_token& stop) { Work(stop); }};
};

}  // namespace

StartedProgram Start(const Command& command) {
  AllowForkUnderSanitizer();
  Ends input = Socket();
  Ends output = Pipe();
  Ends messages = Pipe();
  std::vector<std::string> words = {"/bin/sh", "-c", LineFor(command.line)};
  std::vector<std::string> variables = Environment();
  const std::vector<char*> arguments = Pointers(words);
  const std::vector<char*> environment = Pointers(variables);
  const std::string folder = command.folder.string();
  const pid_t parent = getpid();
  RequireThatChildrenMayStart();
  static Starter starter;
  const pid_t pid = starter.Run([&] {
    const pid_t child = fork();
    if (child != 0) return Checked(child, "fork");
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(0);  // The parent died before the call of prctl.
    Become(folder.c_str(), arguments.data(), environment.data(), input.theirs.get(),
           output.theirs.get(), messages.theirs.get());
  });
  setpgid(pid, pid);  // Both processes do it, so that it is done whoever comes first.
  return {pid, std::move(input.ours), std::move(output.ours), std::move(messages.ours)};
}

}  // namespace touchstone
