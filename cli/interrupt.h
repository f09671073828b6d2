#pragma once

namespace touchstone {

/** Whether the first signal kills the engines that run in child processes. */
enum class WorkingEngines {
  kFinish,  ///< They finish their question.
  kEnd,     ///< They are killed. The caller must drop every answer that comes later.
};

/** Turns the first SIGINT (Ctrl-C) or SIGTERM into a request to stop, while it lives. One
 that comes more than half a second later ends the program at once. Only one may live at a
 time. */
class Interrupt {
 public:
  explicit Interrupt(WorkingEngines engines);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /** Returns the signal that came; 0 if none did. Thread safe. */
  static int signal();
};

}  // namespace touchstone
