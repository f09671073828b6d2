#include "oracles/isolation/isolated_oracle.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "oracles/isolation/answer_wire.h"
#include "oracles/isolation/answering_child.h"
#include "oracles/isolation/child_context.h"
#include "oracles/isolation/child_process.h"
#include "oracles/isolation/recording_child.h"
#include "oracles/no_answer.h"
#include "oracles/stopwatch.h"

namespace touchstone {
namespace {

// The longest valid contact answer: a thousand times the longest of any engine.
constexpr std::size_t kLongestAnswer = std::size_t{1} << 20;  // [bytes]

ContactAnswer AnswerOrCrash(const Oracle& oracle, const ContactQuery& query) {
  try {
    return oracle.Answer(query);
  } catch (...) {
    return CrashedByException();
  }
}

Trajectory NoTrajectory(AnswerStatus status, std::string reason) {
  Trajectory trajectory;
  trajectory.status = status;
  trajectory.reason = std::move(reason);
  return trajectory;
}

Trajectory SimulateOrCrash(const Oracle& oracle, const World& world) {
  try {
    return oracle.Simulate(world);
  } catch (...) {
    const ContactAnswer crash = CrashedByException();
    return NoTrajectory(crash.status, crash.reason);
  }
}

std::string CouldNotIsolate(const std::exception& exception) {
  return std::string("could not be isolated: ") + exception.what();
}

class IsolatedOracle final : public Oracle {
 public:
  IsolatedOracle(std::unique_ptr<Oracle> oracle, const IsolationLimits& limits,
                 IsolationScope scope)
      : oracle_(std::move(oracle)),
        limits_(limits),
        scope_(scope),
        info_(oracle_->info()) {
    if (scope == IsolationScope::kEverything) {
      info_.isolated = true;
      info_.settings.push_back(
          {"process", "a separate child process for each batch",
           "The engine can abort, crash or hang on a valid question."});
      info_.settings.push_back(
          {"deadline", std::to_string(limits_.cpu.count()) + " ms of CPU time",
           "Measured in the child, so that a busy machine changes nothing."});
    }
    if (info_.simulates) {
      info_.settings.push_back(
          {"world: process", "a separate child process for each batch of worlds",
           "The engine can abort, crash or hang on a valid world. The last line of its "
           "standard error is shown with the answer."});
      info_.settings.push_back(
          {"world: deadline",
           std::to_string(limits_.world_cpu.count()) + " ms of CPU time",
           "Measured in the child."});
    }
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    if (!info_.isolated) return oracle_->Answer(queries, answers);
    std::size_t next = 0;
    while (next < queries.size()) {
      try {
        AnswerUntilDeath(queries, answers, next);
      } catch (const std::exception& exception) {
        // A failure of the system, not of the engine.
        answers[next++] = UnsupportedAnswer(CouldNotIsolate(exception));
      }
    }
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return oracle_->Prepare(queries);
  }

  std::string CannotSimulate(const World& world) const override {
    return oracle_->CannotSimulate(world);
  }

  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return oracle_->BeginWith(world, values);
  }

  std::unique_ptr<Simulation> Begin(const World& world) const override {
    return oracle_->Begin(world);
  }

  std::unique_ptr<Simulation> BeginAsShipped(const World& world) const override {
    return oracle_->BeginAsShipped(world);
  }

  std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                             int threads) const override {
    return oracle_->BeginInThreads(world, threads);
  }

  std::unique_ptr<Oracle> SetUp(const WorldSetup& setup) const override {
    return std::make_unique<IsolatedOracle>(oracle_->SetUp(setup), limits_, scope_);
  }

  Trajectory Simulate(const World& world) const override {
    return std::move(SimulateEach(std::span(&world, 1)).front());
  }

  std::vector<Trajectory> SimulateEach(std::span<const World> worlds) const override {
    std::vector<Trajectory> trajectories(worlds.size());
    std::vector<std::size_t> supported;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
      if (CannotSimulate(worlds[i]).empty())
        supported.push_back(i);
      else
        trajectories[i] = oracle_->Simulate(worlds[i]);
    }
    for (std::span<const std::size_t> left = supported; !left.empty();) {
      try {
        SimulateUntilDeath(worlds, trajectories, left);
      } catch (const std::exception& exception) {
        // A failure of the system, not of the engine.
        trajectories[left.front()] =
            NoTrajectory(AnswerStatus::kUnsupported, CouldNotIsolate(exception));
        left = left.subspan(1);
      }
    }
    return trajectories;
  }

 private:
  // Answers the queries from `next` on in one child, up to the query that kills it, to
  // the last one, or until its records are full.
  void AnswerUntilDeath(std::span<const ContactQuery> queries,
                        std::span<ContactAnswer> answers, std::size_t& next) const {
    const std::span<const ContactQuery> left = queries.subspan(next);
    const Stopwatch watch;
    double told = 0;  // What the answers say that they took. [s]
    RecordingChild child(
        left.size(),
        [&](std::size_t i) { return ToWire(AnswerOrCrash(*oracle_, left[i])); },
        {limits_.cpu, limits_.wall, limits_.memory, kLongestAnswer});
    while (next < queries.size()) {
      std::optional<ContactAnswer> answer = child.Next(&FromWire);
      if (!answer) {
        if (child.IsFull()) return;
        ChildProcess::Ending ending = child.LastWords();
        answers[next] = ContactAnswer{};
        answers[next].status = ending.status;
        answers[next].seconds = std::max(0.0, watch.seconds() - told);
        answers[next++].reason = std::move(ending.reason);
        return;
      }
      told += answer->seconds;
      answers[next++] = *std::move(answer);
    }
  }

  // Simulates the remaining worlds, whose indices are in `left`, in one child, up to the
  // world that kills it or to the last one. Removes them from `left`.
  void SimulateUntilDeath(std::span<const World> worlds,
                          std::span<Trajectory> trajectories,
                          std::span<const std::size_t>& left) const {
    const std::span<const std::size_t> asked = left;
    AnsweringChild child(
        asked.size(),
        [&](std::size_t i) {
          Trajectory trajectory = SimulateOrCrash(*oracle_, worlds[asked[i]]);
          trajectory.complaint = ChildContext::LastLine();
          return ToWire(trajectory);
        },
        {limits_.world_cpu, limits_.world_wall, limits_.memory, limits_.memory});
    while (!left.empty()) {
      const Stopwatch watch;
      std::optional<Trajectory> trajectory = child.Next(&TrajectoryFromWire);
      const bool died = !trajectory;
      if (died) {
        ChildProcess::Ending ending = child.LastWords();
        trajectory = NoTrajectory(ending.status, std::move(ending.reason));
        trajectory->seconds = watch.seconds();
      }
      trajectories[left.front()] = *std::move(trajectory);
      left = left.subspan(1);
      if (died) return;
    }
  }

  std::unique_ptr<Oracle> oracle_;
  IsolationLimits limits_;
  IsolationScope scope_;
  OracleInfo info_;
};

}  // namespace

std::unique_ptr<Oracle> Isolate(std::unique_ptr<Oracle> oracle,
                                const IsolationLimits& limits, IsolationScope scope) {
  if (oracle->info().isolated) return oracle;
  return std::make_unique<IsolatedOracle>(std::move(oracle), limits, scope);
}

}  // namespace touchstone
