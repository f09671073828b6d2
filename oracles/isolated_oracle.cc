#include "oracles/isolated_oracle.h"

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "oracles/answering_child.h"
#include "oracles/no_answer.h"

namespace touchstone {
namespace {

class IsolatedOracle final : public Oracle {
 public:
  IsolatedOracle(std::unique_ptr<Oracle> oracle, const IsolationLimits& limits)
      : oracle_(std::move(oracle)), limits_(limits), info_(oracle_->info()) {
    info_.isolated = true;
    info_.settings.push_back(
        {"process", "a child of its own, one for each batch",
         "The engine can abort, crash or hang on a valid question."});
    info_.settings.push_back(
        {"deadline", std::to_string(limits_.cpu.count()) + " ms of CPU time",
         "Counted in the child, so that a busy machine changes nothing."});
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    std::size_t next = 0;
    while (next < queries.size()) {
      try {
        AnswerUntilDeath(queries, answers, next);
      } catch (const std::exception& exception) {
        // The system's fault, not the engine's.
        answers[next++] =
            UnsupportedAnswer(std::string("could not be isolated: ") + exception.what());
      }
    }
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return oracle_->Prepare(queries);
  }

 private:
  // Answers from `next` on, by one child, up to the question it dies of or the last.
  void AnswerUntilDeath(std::span<const ContactQuery> queries,
                        std::span<ContactAnswer> answers, std::size_t& next) const {
    AnsweringChild child(*oracle_, queries.subspan(next), limits_);
    while (next < queries.size()) {
      std::optional<ContactAnswer> answer = child.Next();
      const bool died = !answer;
      answers[next++] = died ? child.LastWords() : *std::move(answer);
      if (died) return;
    }
  }

  std::unique_ptr<Oracle> oracle_;
  IsolationLimits limits_;
  OracleInfo info_;
};

}  // namespace

std::unique_ptr<Oracle> Isolate(std::unique_ptr<Oracle> oracle,
                                const IsolationLimits& limits) {
  if (oracle->info().isolated) return oracle;
  return std::make_unique<IsolatedOracle>(std::move(oracle), limits);
}

}  // namespace touchstone
