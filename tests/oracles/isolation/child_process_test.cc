#include "oracles/isolation/child_process.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "oracles/isolation/sanitizers.h"

namespace touchstone {
namespace {

using std::chrono::milliseconds;

constexpr ChildLimits kLimits = {milliseconds(1000), milliseconds(10'000),
                                 std::size_t{1} << 30, std::size_t{1} << 24};

// Volatile, so that the compiler cannot remove the endless loops.
volatile int forever = 1;

void Hang() {
  while (forever != 0) {
  }
}

void Block() {
  while (forever != 0) pause();
}

void Print(const std::string& text) {
  std::fputs(text.c_str(), stderr);
}

std::optional<std::string> AsText(std::string_view bytes) {
  return std::string(bytes);
}

std::optional<std::string> NeverValid(std::string_view) {
  return std::nullopt;
}

// Runs `main` in a child until its first message or its end, and returns that.
std::string MessageOrReason(const ChildProcess::Main& main,
                            const ChildLimits& limits = kLimits) {
  ChildProcess child(limits, [&](ChildContext& parent) {
    parent.StartTask();
    main(parent);
  });
  const std::optional<std::string> message = child.Receive(&AsText);
  return message ? *message : child.End().reason;
}

std::string ReasonOf(const std::function<void()>& deed,
                     const ChildLimits& limits = kLimits) {
  return MessageOrReason([&](ChildContext&) { deed(); }, limits);
}

// Returns the last line kept of a child that prints `text`.
std::string LastLineAfter(std::string_view text) {
  ChildProcess child(kLimits, [&](ChildContext& parent) {
    while (!text.empty()) {
      const ssize_t count = write(STDERR_FILENO, text.data(), text.size());
      if (count <= 0) break;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    parent.Send("done");
  });
  EXPECT_EQ(child.Receive(&AsText), "done");
  return child.LastLine();
}

TEST(ChildProcess, ExchangesMessagesOfAnyLength) {
  ChildProcess child(kLimits, [](ChildContext& parent) {
    for (;;) parent.Send(std::string(parent.Receive()) + "!");
  });
  for (const std::size_t length : {0UL, 1UL, 70'000UL, 3'000'000UL}) {
    const std::string text(length, 'x');
    child.Send(text);
    EXPECT_EQ(child.Receive(&AsText), text + "!");
  }
}

TEST(ChildProcess, HasTheLastLinePrintedBeforeAnAbortAsAReason) {
  EXPECT_EQ(ReasonOf([] {
              Print("one\nengine.cc:7: void f(): Assertion `x > 0' failed.\n");
              std::abort();
            }),
            "aborted: engine.cc:7: Assertion `x > 0' failed.");
  EXPECT_EQ(ReasonOf([] {
              Print("out of bodies\n");
              std::raise(SIGSEGV);
            }),
            "killed by SIGSEGV: out of bodies");
  EXPECT_EQ(ReasonOf([] { std::exit(3); }), "exited with status 3");
  EXPECT_EQ(ReasonOf([] {}), "exited with status 0");
}

TEST(ChildProcess, HasAnExceptionAsAReasonAndDestroysNoObjectOfTheParent) {
  const std::string file = testing::TempDir() + "destroyed_in_the_child";
  {
    // Unwinding beyond `main` would destroy this object in the child too.
    struct Guard {
      const std::string& file;
      pid_t parent = getpid();
      ~Guard() {
        if (getpid() != parent) std::fclose(std::fopen(file.c_str(), "w"));
      }
    } guard{file};
    EXPECT_EQ(ReasonOf([] { throw std::logic_error("a flat simplex"); }),
              "aborted: threw std::logic_error: a flat simplex");
  }
  EXPECT_NE(access(file.c_str(), F_OK), 0);
}

TEST(ChildProcess, IsStoppedAtTheLimitOfCpuTime) {
  ChildLimits limits = kLimits;
  limits.cpu = milliseconds(100);
  ChildProcess child(limits, [&](ChildContext& parent) {
    parent.StartTask();
    Hang();
  });
  EXPECT_EQ(child.Receive(&AsText), std::nullopt);
  const ChildProcess::Ending ending = child.End();
  EXPECT_EQ(ending.status, AnswerStatus::kTimedOut);
  EXPECT_EQ(ending.reason, "no answer after 0.1 s of CPU time");
}

TEST(ChildProcess, HasItsCpuTimeForEachTask) {
  ChildLimits limits = kLimits;
  limits.cpu = milliseconds(300);
  const auto work = [] {
    const std::clock_t end = std::clock() + CLOCKS_PER_SEC / 5;
    while (std::clock() < end) {
    }
  };
  EXPECT_EQ(MessageOrReason(
                [&](ChildContext& parent) {
                  for (int task = 0; task < 3; ++task) {
                    parent.StartTask();
                    work();
                  }
                  parent.Send("worked");
                },
                limits),
            "worked");
}

TEST(ChildProcess, IsStoppedIfItBlocksWithOrWithoutAnOpenSocket) {
  ChildLimits limits = kLimits;
  limits.wall = milliseconds(200);
  EXPECT_EQ(ReasonOf(&Block, limits), "no answer after 0.2 s, blocked");
  EXPECT_EQ(ReasonOf(
                [] {
                  for (int fd = 0; fd < 64; ++fd) close(fd);
                  Block();
                },
                limits),
            "no answer after 0.2 s, blocked");
}

TEST(ChildProcess, IsNotWaitedForAgainAfterItsEnd) {
  ChildLimits limits = kLimits;
  limits.wall = milliseconds(200);
  ChildProcess child(limits, [](ChildContext&) { Block(); });
  EXPECT_EQ(child.Receive(&AsText), std::nullopt);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 50; ++i) {
    child.Send("go on");
    EXPECT_EQ(child.Receive(&AsText), std::nullopt);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_EQ(child.End().reason, "no answer after 0.2 s, blocked");
  EXPECT_EQ(child.End().reason, "no answer after 0.2 s, blocked");
}

TEST(ChildProcess, IsStoppedByAnInvalidMessage) {
  const std::string reason = "sent bytes that are not an answer";
  ChildLimits limits = kLimits;
  limits.message = 10;
  const auto send = [](ChildContext& parent) { parent.Send("eleven more"); };
  EXPECT_EQ(MessageOrReason(send), "eleven more");
  EXPECT_EQ(MessageOrReason(send, limits), reason);
  ChildProcess child(kLimits, [](ChildContext& parent) {
    for (;;) parent.Send("eleven more");
  });
  EXPECT_EQ(child.Receive(&NeverValid), std::nullopt);
  EXPECT_EQ(child.Receive(&AsText), std::nullopt);
  EXPECT_EQ(child.End().reason, reason);
}

TEST(ChildProcess, CannotExhaustTheMemory) {
  if (kSanitizerReservesMemory)
    GTEST_SKIP() << "the sanitizer reserves more memory than the limit";
  EXPECT_EQ(ReasonOf([] {
              void* memory = mmap(nullptr, std::size_t{2} << 30, PROT_READ,
                                  MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
              std::exit(memory == MAP_FAILED ? 1 : 2);
            }),
            "exited with status 1");
}

TEST(ChildProcess, WritesNoCoreFile) {
  EXPECT_EQ(ReasonOf([] {
              rlimit limit;
              getrlimit(RLIMIT_CORE, &limit);
              std::exit(limit.rlim_cur == 0 ? 1 : 2);
            }),
            "exited with status 1");
}

TEST(ChildProcess, HasTheDefaultSignalsWhateverTheParentHas) {
  std::signal(SIGABRT, [](int) { _exit(77); });
  std::signal(SIGTERM, SIG_IGN);
  sigset_t blocked;
  sigset_t before;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGPROF);
  sigprocmask(SIG_BLOCK, &blocked, &before);
  EXPECT_EQ(ReasonOf([] { std::abort(); }), "aborted");
  EXPECT_EQ(ReasonOf([] { std::raise(SIGTERM); }), "killed by SIGTERM");
  ChildLimits limits = kLimits;
  limits.cpu = milliseconds(100);
  limits.wall = milliseconds(5'000);
  EXPECT_EQ(ReasonOf(&Hang, limits), "no answer after 0.1 s of CPU time");
  // The terminal sends these to the parent too.
  EXPECT_EQ(ReasonOf([] { std::raise(SIGINT); }), "exited with status 0");
  sigprocmask(SIG_SETMASK, &before, nullptr);
  std::signal(SIGABRT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

TEST(ChildProcess, HasNoDescriptorOfTheParentExceptStdin) {
  const int file = open("/dev/null", O_RDONLY);
  const std::string open_in_child = MessageOrReason([](ChildContext& parent) {
    std::string list;
    for (int fd = 1; fd < 1024; ++fd) {
      if (fcntl(fd, F_GETFD) != -1) list += std::to_string(fd) + ' ';
    }
    parent.Send(list);
  });
  EXPECT_EQ(open_in_child, "1 2 3 4 ");
  close(file);
}

TEST(ChildProcess, DoesNotWriteToTheStdoutOfTheParent) {
  testing::internal::CaptureStdout();
  std::fputs("parent;", stdout);  // Still in the buffer when the child is forked.
  ReasonOf([] {
    std::fputs("child;", stdout);
    std::fflush(stdout);
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "parent;");
}

TEST(ChildProcess, IsKilledByTheDestructorWhichClosesAllFiles) {
  const auto count = [] {
    int open = 0;
    for (int fd = 0; fd < 1024; ++fd) open += fcntl(fd, F_GETFD) != -1 ? 1 : 0;
    return open;
  };
  const int before = count();
  for (int i = 0; i < 3; ++i)
    const ChildProcess child(kLimits, [](ChildContext&) { Block(); });
  EXPECT_EQ(count(), before);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(ChildProcess, ThrowsIfTheSystemHasNoDescriptorLeft) {
  if (kSanitizerOpensPipes)
    GTEST_SKIP() << "the sanitizer needs descriptors to check std::system_error";
  rlimit before;
  getrlimit(RLIMIT_NOFILE, &before);
  rlimit none = before;
  none.rlim_cur = 3;
  setrlimit(RLIMIT_NOFILE, &none);
  EXPECT_THROW(ChildProcess(kLimits, [](ChildContext&) {}), std::system_error);
  setrlimit(RLIMIT_NOFILE, &before);
}

TEST(LastLineOfAChild, IsTheLastThatIsNotEmpty) {
  EXPECT_EQ(LastLineAfter("one\ntwo\tof two\n\n  \n"), "two of two");
}

TEST(LastLineOfAChild, NeedsNoNewline) {
  EXPECT_EQ(LastLineAfter("one\ntwo"), "two");
}

TEST(LastLineOfAChild, IsEmptyIfTheChildPrintsNothing) {
  EXPECT_EQ(LastLineAfter(""), "");
}

TEST(LastLineOfAChild, EndsAfter64MebibytesWhichDoNotKillTheChild) {
  std::string lines;
  for (int i = 0; i < 70 << 10; ++i) {
    std::string line = std::to_string(i);
    line.resize(1023, ' ');
    lines += line + '\n';
  }
  EXPECT_EQ(LastLineAfter(lines), std::to_string((64 << 10) - 1));
}

TEST(LastLineOfAChild, IsThatOfTheCurrentTask) {
  const std::string lines = MessageOrReason([](ChildContext& parent) {
    Print("first\n");
    const std::string before = ChildContext::LastLine();
    parent.StartTask();
    const std::string between = ChildContext::LastLine();
    Print("second\n");
    parent.Send(before + ";" + between + ";" + ChildContext::LastLine());
  });
  EXPECT_EQ(lines, "first;;second");
}

}  // namespace
}  // namespace touchstone
