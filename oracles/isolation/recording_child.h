#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "oracles/isolation/child_process.h"

namespace touchstone {

/** A child process that answers questions one after the other until all are answered, its
 records are full, or it dies. Its answers are read once it has ended. An AnsweringChild
 sends each answer at once instead: it needs no memory for them, but wakes this process
 each time, which takes longer than most contact queries. */
class RecordingChild {
 public:
  /** Returns the bytes of the answer to a question. Called in the child. */
  using Answerer = std::function<std::string(std::size_t question)>;

  /** Forks a child that answers the first `count` questions, each within `limits`.
   @throws std::system_error if the system provides no process, socket or file. */
  RecordingChild(std::size_t count, const Answerer& answerer, const ChildLimits& limits)
      : child_(limits, [&](ChildContext& context) {
          for (std::size_t question = 0; question < count; ++question) {
            if (context.recorded() >= kFull) return;
            context.StartTask();
            context.Record(answerer(question));
          }
        }) {}

  /** Waits for the end of the child and decodes the answer to the next question. Returns
   nothing if the child has not answered it. */
  template <typename Answer>
  std::optional<Answer> Next(std::optional<Answer> (*decode)(std::string_view)) {
    return child_.NextRecord(decode);
  }

  /** Returns whether the child has stopped because its records are full.
   @pre Next() has returned nothing. */
  bool IsFull() const { return child_.taken() >= kFull; }

  /** Returns how the child ended, as the answer to the question it was working on.
   @pre Next() has returned nothing, and the records are not full. */
  ChildProcess::Ending LastWords() { return child_.End(); }

 private:
  /** Size from which on nothing more is recorded: fifty thousand answers. [bytes] */
  static constexpr std::size_t kFull = std::size_t{1} << 24;

  ChildProcess child_;
};

}  // namespace touchstone
