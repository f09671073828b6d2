#pragma once

namespace touchstone {

/** What a request to stop does to engines that are at work in child processes. */
enum class WorkingEngines {
  kFinish,  ///< They finish their question.
  kEnd,     ///< They are ended. Answers that come later mean nothing and must be dropped.
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
