#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "oracles/contact_answer.h"

namespace touchstone {

/** A child process that answers questions one after the other until all are answered or
 it dies. */
class AnsweringChild {
 public:
  /** Returns the bytes of the answer to a question. Called in the child. */
  using Answerer = std::function<std::string(std::size_t question)>;

  /** The resources that the child may use for each question. */
  struct Limits {
    std::chrono::milliseconds cpu;
    std::chrono::milliseconds wall;
    std::size_t memory;  ///< Address space beyond that in use at the fork. [bytes]
    std::size_t answer;  ///< Longest valid answer. [bytes]
  };

  /** How the child ended, as the answer to the question it was working on. */
  struct Ending {
    AnswerStatus status;
    std::string reason;
  };

  /** Forks a child that answers the first `count` questions.
   @throws std::system_error if the system provides no process, pipe or file. */
  AnsweringChild(std::size_t count, const Answerer& answerer, const Limits& limits);

  /** Kills the child if it is still running, and waits for its end. */
  ~AnsweringChild();

  AnsweringChild(const AnsweringChild&) = delete;
  AnsweringChild& operator=(const AnsweringChild&) = delete;

  /** Waits for the answer to the next question and decodes its bytes. Returns nothing if
   the child will not answer. */
  template <typename Answer>
  std::optional<Answer> Next(std::optional<Answer> (*decode)(std::string_view)) {
    const std::optional<std::string_view> bytes = NextBytes();
    if (!bytes) return std::nullopt;
    std::optional<Answer> answer = decode(*bytes);
    if (!answer) silence_ = Silence::kNonsense;
    return answer;
  }

  /** Returns how the child ended. To be called after Next() has returned nothing. */
  Ending LastWords();

  /** Returns the last line that the child has printed to its standard error on the
   current question; empty if it has printed nothing. To be called in the child. */
  static std::string LastLine();

 private:
  // The reason why there is no next answer.
  enum class Silence { kDeath, kNonsense, kBlocked };

  [[noreturn]] void Run(std::size_t count, const Answerer& answerer);
  std::optional<std::string_view> NextBytes();  // Valid until the next call.
  bool ReadMore();
  int Kill();
  bool IsDead() const;

  Limits limits_;
  pid_t pid_ = -1;
  int answers_fd_ = -1;  // The parent's end of the pipe.
  int output_fd_ = -1;   // An unnamed file: the child's stderr on this question.
  std::string received_;
  std::size_t taken_ = 0;  // Bytes of received_ that NextBytes() has returned.
  Silence silence_ = Silence::kDeath;
};

}  // namespace touchstone
