#include "oracles/function_oracle.h"

#include <limits>

#include "oracles/answer_each.h"

namespace touchstone {
namespace {

OracleInfo InfoOf(std::string name, const std::vector<ShapePair>& pairs,
                  const Promises& promises) {
  OracleInfo info;
  info.name = std::move(name);
  info.library = "user";
  info.version = "unversioned";  // Not empty, because ledger entries name a version.
  info.settings.push_back(
      {"conventions", "as the function returns them", "the function converts by itself"});
  info.unit_roundoff =
      promises.precision == Precision::kFloat ? kFloatRoundoff : kDoubleRoundoff;
  StatedTolerance tolerance = promises.tolerance;
  if (tolerance.by.empty()) tolerance.by = promises.documented_by;
  SetTolerance(std::move(tolerance), info);
  for (auto& row : info.capabilities) {
    for (Capability& capability : row) {
      capability.reason = "the function of " + info.name + " does not handle this pair";
    }
  }
  for (const ShapePair& pair : pairs) {
    info.capabilities[static_cast<std::size_t>(pair.A)]
                     [static_cast<std::size_t>(pair.B)] = promises.gives;
  }
  return info;
}

class FunctionOracle final : public Oracle {
 public:
  FunctionOracle(OracleInfo info, ContactFunction function)
      : info_(std::move(info)), function_(std::move(function)) {}

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    AnswerEach(info_, queries, answers, function_);
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override;

 private:
  OracleInfo info_;
  ContactFunction function_;
};

// The prepared batch of a function, which has no objects to build: it keeps the queries.
class FunctionBatch final : public PreparedBatch {
 public:
  FunctionBatch(const Oracle& oracle, std::span<const ContactQuery> queries)
      : oracle_(oracle),
        queries_(queries.begin(), queries.end()),
        answers_(queries.size()) {}

  void Run() override {
    oracle_.Answer(queries_, answers_);
    separations_.clear();
    for (const ContactAnswer& answer : answers_) {
      separations_.push_back(
          answer.separation.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
  }

  std::span<const double> separations() const override { return separations_; }

 private:
  const Oracle& oracle_;
  std::vector<ContactQuery> queries_;
  std::vector<ContactAnswer> answers_;
  std::vector<double> separations_;
};

std::unique_ptr<PreparedBatch> FunctionOracle::Prepare(
    std::span<const ContactQuery> queries) const {
  return std::make_unique<FunctionBatch>(*this, queries);
}

}  // namespace

Capability DepthAndNormal() {
  Capability gives;
  gives.supported = true;
  gives.family = "user";
  gives.depth = true;
  gives.normal = true;
  return gives;
}

std::unique_ptr<Oracle> MakeOracle(std::string name, const std::vector<ShapePair>& pairs,
                                   ContactFunction function, const Promises& promises) {
  return std::make_unique<FunctionOracle>(InfoOf(std::move(name), pairs, promises),
                                          std::move(function));
}

}  // namespace touchstone
