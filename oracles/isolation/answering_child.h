#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "oracles/isolation/child_process.h"

namespace touchstone {

/** A child process that answers questions one after the other until all are answered or
 it dies. */
class AnsweringChild {
 public:
  /** Returns the bytes of the answer to a question. Called in the child. */
  using Answerer = std::function<std::string(std::size_t question)>;

  /** Forks a child that answers the first `count` questions, each within `limits`.
   @throws std::system_error if the system provides no process, socket or file. */
  AnsweringChild(std::size_t count, const Answerer& answerer, const ChildLimits& limits)
      : child_(limits, [&](ChildContext& context) {
          for (std::size_t question = 0; question < count; ++question) {
            context.StartTask();
            context.Send(answerer(question));
          }
        }) {}

  /** Waits for the answer to the next question and decodes its bytes. Returns nothing if
   the child will not answer. */
  template <typename Answer>
  std::optional<Answer> Next(std::optional<Answer> (*decode)(std::string_view)) {
    return child_.Receive(decode);
  }

  /** Returns how the child ended, as the answer to the question it was working on.
   @pre Next() has returned nothing. */
  ChildProcess::Ending LastWords() { return child_.End(); }

 private:
  ChildProcess child_;
};

}  // namespace touchstone
