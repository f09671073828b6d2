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

/** A child process that answers questions one after the other, until it is done or dies.
 */
class AnsweringChild {
 public:
  /** Returns the bytes of the answer to a question. Called in the child. */
  using Answerer = std::function<std::string(std::size_t question)>;

  /** What the child may take for each question. */
  struct Limits {
    std::chrono::milliseconds cpu;
    std::chrono::milliseconds wall;
    std::size_t memory;  ///< Address space beyond what the process has already. [bytes]
    std::size_t answer;  ///< A longer answer is none. [bytes]
  };

  /** How the child ended, as the answer to the question that it was at. */
  struct Ending {
    AnswerStatus status;
    std::string reason;
  };

  /** Forks a child that answers the first `count` questions.
   @throws std::system_error where the system gives no process, pipe or file. */
  AnsweringChild(std::size_t count, const Answerer& answerer, const Limits& limits);

  /** Ends the child, if it has not ended, and waits for that. */
  ~AnsweringChild();

  AnsweringChild(const AnsweringChild&) = delete;
  AnsweringChild& operator=(const AnsweringChild&) = delete;

  /** Waits for the answer to the next question and decodes its bytes; nothing where the
   child will give none. */
  template <typename Answer>
  std::optional<Answer> Next(std::optional<Answer> (*decode)(std::string_view)) {
    const std::optional<std::string_view> bytes = NextBytes();
    if (!bytes) return std::nullopt;
    std::optional<Answer> answer = decode(*bytes);
    if (!answer) silence_ = Silence::kNonsense;
    return answer;
  }

  /** Returns, after Next() gave nothing, how the child ended. */
  Ending LastWords();

  /** Returns, in the child, the last line that it has printed to its standard error on
   the question that it is at; empty where it has printed nothing. */
  static std::string LastLine();

 private:
  // Why there is no next answer.
  enum class Silence { kDeath, kNonsense, kBlocked };

  [[noreturn]] void Run(std::size_t count, const Answerer& answerer);
  std::optional<std::string_view> NextBytes();  // Valid until it is called again.
  bool ReadMore();
  int Kill();
  bool IsDead() const;

  Limits limits_;
  pid_t pid_ = -1;
  int answers_fd_ = -1;  // Our end of the pipe.
  int output_fd_ = -1;   // An unnamed file: the child's stderr on this question.
  std::string received_;
  std::size_t taken_ = 0;  // Of what is received, this much was returned. [bytes]
  Silence silence_ = Silence::kDeath;
};

}  // namespace touchstone
