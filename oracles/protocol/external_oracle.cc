#include "oracles/protocol/external_oracle.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "oracles/no_answer.h"
#include "oracles/protocol/answer_message.h"
#include "oracles/protocol/hello_message.h"
#include "oracles/protocol/program.h"
#include "oracles/protocol/query_message.h"
#include "oracles/protocol/trajectory_message.h"
#include "oracles/protocol/world_message.h"
#include "oracles/stopwatch.h"

namespace touchstone {
namespace {

// Questions in a message. More of them gain nothing measurable, and cost more if the
// program fails. A frame costs so little that the switch between two processes counts.
constexpr std::size_t kBatch = 16;
constexpr std::size_t kBatchInFrames = 256;

Message Asking(const char* method) {
  return {{{"method", method}}, {}};
}

/** The running programs of one external oracle, shared by all its setups. */
class Programs {
 public:
  Programs(std::string name, Command command, const ExternalLimits& limits)
      : name_(std::move(name)), command_(std::move(command)), limits_(limits) {}

  /** Returns a program that has described itself, and its description.
   Throws NoReply. */
  std::pair<std::unique_ptr<Program>, Hello> StartOne() const {
    try {
      auto program = std::make_unique<Program>(command_);
      Message message = Asking("hello");
      message.line["protocol"] = kProtocolVersion;
      Hello hello = HelloFrom(program->Ask(std::move(message), limits_.hello), name_);
      return {std::move(program), std::move(hello)};
    } catch (const ProtocolError& error) {
      throw NoReply{AnswerStatus::kCrashed, error.what()};
    } catch (const std::system_error& error) {
      throw NoReply{AnswerStatus::kCrashed, error.what()};
    }
  }

  /** Returns a program that nobody else asks, an idle one if there is one. Throws
   NoReply. */
  std::unique_ptr<Program> Take() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<Program> program = std::move(idle_.back());
        idle_.pop_back();
        return program;
      }
    }
    return StartOne().first;
  }

  /** Keeps a program that has answered for the next question. */
  void GiveBack(std::unique_ptr<Program> program) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(program));
  }

  const ExternalLimits& limits() const { return limits_; }

  /** The most questions in a message: fewer once a batch has taken longer than one
   question may. */
  std::size_t batch(bool frames) const {
    return std::min(most_together_.load(), frames ? kBatchInFrames : kBatch);
  }
  void AskFewerTogether(std::size_t than) {
    most_together_ = std::max<std::size_t>(1, than / 4);
  }

 private:
  std::string name_;  // Empty: the one that the program states.
  Command command_;
  ExternalLimits limits_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Program>> idle_;
  std::atomic<std::size_t> most_together_ = kBatchInFrames;
};

ContactAnswer Answered(const NoReply& failure) {
  ContactAnswer answer;
  answer.status = failure.status;
  answer.reason = failure.reason;
  return answer;
}

class ExternalOracle final : public Oracle {
 public:
  ExternalOracle(std::shared_ptr<Programs> programs, OracleInfo info, bool frames)
      : programs_(std::move(programs)), info_(std::move(info)), frames_(frames) {}

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    std::vector<ContactQuery> supported;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Capability& capability =
          info_.For(KindOf(queries[i].A.shape), KindOf(queries[i].B.shape));
      if (!capability.supported) {
        answers[i] = UnsupportedAnswer(capability.reason);
        continue;
      }
      supported.push_back(queries[i]);
      places.push_back(i);
    }
    for (std::size_t begin = 0; begin < supported.size();) {
      const std::size_t count =
          std::min(programs_->batch(frames_), supported.size() - begin);
      std::vector<ContactAnswer> given =
          AnswersTo(std::span(supported).subspan(begin, count));
      for (std::size_t i = 0; i < count; ++i)
        answers[places[begin + i]] = std::move(given[i]);
      begin += count;
    }
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override;

  std::unique_ptr<Oracle> SetUp(const WorldSetup& setup) const override {
    OracleInfo info = info_;
    info.setup = setup;
    return std::make_unique<ExternalOracle>(programs_, std::move(info), frames_);
  }

  Trajectory Simulate(const World& world) const override {
    Trajectory trajectory;
    trajectory.reason = CannotSimulate(world);
    if (!trajectory.reason.empty()) return trajectory;
    const Stopwatch watch;
    try {
      trajectory = MotionOf(world);
    } catch (const NoReply& failure) {
      trajectory.status = failure.status;
      trajectory.reason = failure.reason;
    }
    trajectory.seconds = watch.seconds();
    return trajectory;
  }

 private:
  // Returns the answers to questions that are asked together. Throws NoReply.
  std::vector<ContactAnswer> AskTogether(std::span<const ContactQuery> queries) const {
    const Stopwatch watch;
    std::unique_ptr<Program> program = programs_->Take();
    Message message = Asking("contact");
    PutQueries(queries, frames_, message);
    // The time is that of one question: a program that hangs is not waited for longer.
    AnswerLimits limits = programs_->limits().contact;
    limits.line *= queries.size();
    const Message reply = program->Ask(std::move(message), limits);
    std::vector<ContactAnswer> answers;
    std::optional<NoReply> refusal;  // Of the whole message, by a program that goes on.
    try {
      if (const auto error = Received(reply.line, "answer").Find("error"))
        refusal = NoReply{AnswerStatus::kCrashed, error->Text()};
      else
        answers = AnswersFrom(reply, queries.size());
    } catch (const ProtocolError& error) {
      throw NoReply{AnswerStatus::kCrashed, error.what()};
    }
    programs_->GiveBack(std::move(program));
    if (refusal) throw NoReply(*std::move(refusal));
    const double seconds = watch.seconds() / static_cast<double>(queries.size());
    for (ContactAnswer& answer : answers) answer.seconds = seconds;
    return answers;
  }

  std::vector<ContactAnswer> AnswersTo(std::span<const ContactQuery> queries) const {
    std::string reason;
    AnswerStatus status{};
    try {
      return AskTogether(queries);
    } catch (const NoReply& failure) {
      if (queries.size() == 1) return {Answered(failure)};
      status = failure.status;
      reason = failure.reason;
    }
    std::vector<ContactAnswer> answers;
    bool has_failed = false;  // Not by an error that the program itself states.
    for (const ContactQuery& query : queries) {
      try {
        answers.push_back(AskTogether(std::span(&query, 1)).front());
      } catch (const NoReply& failure) {
        answers.push_back(Answered(failure));
        has_failed = true;
      }
    }
    if (has_failed) return answers;
    if (status == AnswerStatus::kTimedOut) {
      // The limit is that of one question, and each has kept it.
      programs_->AskFewerTogether(queries.size());
    } else {
      // A failure is never passed over, even one that does not come back.
      answers.front() = Answered(
          {status, fmt::format("{}, when this question and the {} after it were asked "
                               "together; each is answered when it is asked alone",
                               reason, queries.size() - 1)});
    }
    return answers;
  }

  // Throws NoReply.
  Trajectory MotionOf(const World& world) const {
    std::unique_ptr<Program> program = programs_->Take();
    Message message = Asking("world");
    if (frames_) message.line["in_frame"] = true;
    message.line["world"] = ToJson(world);
    if (info_.HasSetups())
      message.line["parameters"] = ParametersJson(info_.parameters, info_.setup);
    AnswerLimits limits = programs_->limits().world;
    limits.line = std::max(limits.line, MostBytesOf(world));
    const Message reply = program->Ask(std::move(message), limits);
    Trajectory trajectory;
    try {
      const Received line(reply.line, "answer");
      if (const auto reason = line.Find("unsupported")) {
        trajectory.reason = reason->Text();
      } else if (const auto error = line.Find("error")) {
        trajectory.status = AnswerStatus::kCrashed;
        trajectory.reason = error->Text();
      } else {
        trajectory = TrajectoryFrom(reply, world);
      }
    } catch (const ProtocolError& error) {
      throw NoReply{AnswerStatus::kCrashed, error.what()};
    }
    programs_->GiveBack(std::move(program));
    return trajectory;
  }

  std::shared_ptr<Programs> programs_;
  OracleInfo info_;
  bool frames_;
};

/** A batch of which the translation into messages is timed too: it is part of what a
 question to a program costs. */
class ExternalBatch final : public PreparedBatch {
 public:
  ExternalBatch(const Oracle& oracle, std::span<const ContactQuery> queries)
      : oracle_(oracle),
        queries_(queries.begin(), queries.end()),
        answers_(queries.size()),
        separations_(queries.size()) {}

  void Run() override {
    oracle_.Answer(queries_, answers_);
    for (std::size_t i = 0; i < answers_.size(); ++i)
      separations_[i] =
          answers_[i].separation.value_or(std::numeric_limits<double>::quiet_NaN());
  }

  std::span<const double> separations() const override { return separations_; }

 private:
  const Oracle& oracle_;
  std::vector<ContactQuery> queries_;
  std::vector<ContactAnswer> answers_;
  std::vector<double> separations_;
};

std::unique_ptr<PreparedBatch> ExternalOracle::Prepare(
    std::span<const ContactQuery> queries) const {
  return std::make_unique<ExternalBatch>(*this, queries);
}

}  // namespace

std::unique_ptr<Oracle> MakeExternalOracle(std::string name, const Command& command,
                                           const ExternalLimits& limits) {
  auto programs = std::make_shared<Programs>(std::move(name), command, limits);
  try {
    auto [program, hello] = programs->StartOne();
    programs->GiveBack(std::move(program));
    OracleInfo& info = hello.info;
    info.isolated = true;
    info.external = true;
    info.settings.push_back(
        {"program", command.line,
         "A process of its own that speaks the oracle protocol; a question on which it "
         "fails costs that answer only."});
    return std::make_unique<ExternalOracle>(std::move(programs), std::move(info),
                                            hello.frames);
  } catch (const NoReply& failure) {
    throw std::runtime_error(failure.reason);
  }
}

}  // namespace touchstone
