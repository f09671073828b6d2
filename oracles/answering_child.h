#pragma once

#include <optional>
#include <span>
#include <string>

#include <sys/types.h>

#include "oracles/isolated_oracle.h"
#include "oracles/oracle.h"

namespace touchstone {

/** A child process that answers questions one after the other, until it is done or dies.
 */
class AnsweringChild {
 public:
  /** Forks a child that asks `oracle` all of `queries`.
   @throws std::system_error where the system gives no process, pipe or file. */
  AnsweringChild(const Oracle& oracle, std::span<const ContactQuery> queries,
                 const IsolationLimits& limits);

  /** Ends the child, if it has not ended, and waits for that. */
  ~AnsweringChild();

  AnsweringChild(const AnsweringChild&) = delete;
  AnsweringChild& operator=(const AnsweringChild&) = delete;

  /** Waits for the answer to the next question; nothing where the child will give none.
   */
  std::optional<ContactAnswer> Next();

  /** Returns, after Next() gave nothing, how the child ended, as the answer to the
   question that it was at. */
  ContactAnswer LastWords();

 private:
  // Why there is no next answer.
  enum class Silence { kDeath, kNonsense, kBlocked };

  [[noreturn]] void Run(const Oracle& oracle, std::span<const ContactQuery> queries);
  bool ReadMore();
  int Kill();
  bool IsDead() const;
  std::string LastLine() const;

  IsolationLimits limits_;
  pid_t pid_ = -1;
  int answers_fd_ = -1;  // Our end of the pipe.
  int output_fd_ = -1;   // An unnamed file: the child's stderr on this question.
  std::string received_;
  Silence silence_ = Silence::kDeath;
};

}  // namespace touchstone
