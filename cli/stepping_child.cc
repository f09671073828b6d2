#include "cli/stepping_child.h"

#include <array>
#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/input_error.h"
#include "reports/worlds/deepest_penetration.h"

namespace touchstone {
namespace {

// [µs]
double TimeBy(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e6 * static_cast<double>(time.tv_sec) +
         1e-3 * static_cast<double>(time.tv_nsec);
}

// Time that all threads of this process together have waited for a processor since they
// started: the second number of schedstat. [µs]
double Waited() {
  double sum = 0;
  std::error_code none;
  for (const auto& thread :
       std::filesystem::directory_iterator("/proc/self/task", none)) {
    double ran = 0;
    double waited = 0;
    if (std::ifstream(thread.path() / "schedstat") >> ran >> waited) sum += 1e-3 * waited;
  }
  return sum;
}

// The CPU time of one thread excludes other work of the machine. With several threads it
// is meaningless, since one may work while the others wait.
StepTime Take(Simulation& simulation, int steps) {
  const double waited = Waited();
  const double cpu = TimeBy(CLOCK_THREAD_CPUTIME_ID);
  const double wall = TimeBy(CLOCK_MONOTONIC);
  for (int i = 0; i < steps; ++i) simulation.Step();
  StepTime time;
  time.wall = (TimeBy(CLOCK_MONOTONIC) - wall) / steps;
  time.cpu = (TimeBy(CLOCK_THREAD_CPUTIME_ID) - cpu) / steps;
  time.waited = (Waited() - waited) / steps;
  return time;
}

// Written so that a NaN counts as the largest.
void TakeLarger(double& largest, double value) {
  if (!(value <= largest) && !std::isnan(largest)) largest = value;
}

WorldQuality QualityOf(const World& world, const WorldState& state) {
  WorldQuality quality;
  quality.deepest = DeepestPenetration(world, state).depth;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].mass == 0) continue;
    Eigen::Vector3d moved = state.bodies[i].p_WB - world.bodies[i].placed.X_WB.p_WB;
    moved.y() = 0;
    TakeLarger(quality.fastest, state.bodies[i].v_WB.norm());
    TakeLarger(quality.sideways, moved.norm());
  }
  return quality;
}

// Sends and receives a message of plain bytes as a whole. A broken socket returns false
// and raises no signal.
template <typename Plain>
bool Send(int socket, const Plain& message) {
  return send(socket, &message, sizeof message, MSG_NOSIGNAL) == sizeof message;
}
template <typename Plain>
bool Receive(int socket, Plain& message) {
  return recv(socket, &message, sizeof message, MSG_WAITALL) == sizeof message;
}

}  // namespace

SteppingChild::SteppingChild(const Oracle& oracle, const World& world,
                             const Stepping& stepping) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0)
    throw InputError("cannot create a socket to a child process");
  std::cout.flush();
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    // The child must not outlive its parent, the only reader of its results.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    close(ends[0]);
    error_output_.Take();
    // The limit applies to the CPU time of all threads of the child together.
    const rlim_t seconds =
        static_cast<rlim_t>(stepping.seconds) * static_cast<rlim_t>(stepping.threads);
    const rlimit limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    Run(oracle, world, stepping.threads, ends[1]);
  }
  close(ends[1]);
  orders_ = ends[0];
  if (pid_ < 0) {
    close(orders_);
    throw InputError("cannot create a child process");
  }
}

SteppingChild::~SteppingChild() {
  close(orders_);
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void SteppingChild::Run(const Oracle& oracle, const World& world, int threads,
                        int orders) {
  const std::unique_ptr<Simulation> simulation =
      threads == 1 ? oracle.BeginAsShipped(world) : oracle.BeginInThreads(world, threads);
  bool answered = true;
  for (int steps = 0; answered && Receive(orders, steps);) {
    if (steps == 0) {
      WorldState state;
      simulation->Read(state);
      answered = Send(orders, QualityOf(world, state));
      continue;
    }
    answered = Send(orders, Take(*simulation, steps));
  }
  _exit(0);
}

template <typename Reply>
std::optional<Reply> SteppingChild::Ask(int steps) {
  Reply reply;
  if (!Send(orders_, steps) || !Receive(orders_, reply)) return std::nullopt;
  return reply;
}

std::optional<StepTime> SteppingChild::Step(int steps) {
  return Ask<StepTime>(steps);
}

std::optional<WorldQuality> SteppingChild::Quality() {
  return Ask<WorldQuality>(0);
}

}  // namespace touchstone
