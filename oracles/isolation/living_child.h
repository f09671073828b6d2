#pragma once

#include <atomic>

#include <sys/types.h>

namespace touchstone {

/** The registration of a running child process, which EndChildren() kills. */
class LivingChild {
 public:
  /** Takes a target of kill(2): a process, or if it is negative the process group of that
   number. Kills it if EndChildren() has been called. */
  explicit LivingChild(pid_t target);

  /** @pre The process has not been waited for: after that, its number may be that of
   another. */
  ~LivingChild();

  LivingChild(const LivingChild&) = delete;
  LivingChild& operator=(const LivingChild&) = delete;

 private:
  std::atomic<pid_t>* place_;  // Null if there are too many: it is not killed.
};

/** Kills all registered children, and later ones when they register. Their answers look
 like crashes, so only a program that is about to exit may call it. Safe in a signal
 handler; does nothing in a forked child. */
void EndChildren() noexcept;

/** Throws std::system_error if EndChildren() has been called. */
void RequireThatChildrenMayStart();

}  // namespace touchstone
