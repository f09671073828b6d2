#include "reports/bench/step_time.h"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <system_error>

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

}  // namespace

StepTime TimeSteps(Simulation& simulation, int steps) {
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

}  // namespace touchstone
