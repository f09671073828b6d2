#include "oracles/world_setup.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "oracles/oracle.h"

namespace touchstone {
namespace {

class SetUpOracle final : public Oracle {
 public:
  SetUpOracle(const Oracle& oracle, const WorldSetup& setup)
      : oracle_(oracle), info_(oracle.info()) {
    info_.setup = setup;
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    oracle_.Answer(queries, answers);
  }
  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return oracle_.Prepare(queries);
  }
  std::string CannotSimulate(const World& world) const override {
    return oracle_.CannotSimulate(world);
  }
  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return oracle_.BeginWith(world, values);
  }
  std::unique_ptr<Simulation> Begin(const World& world) const override {
    if (!info_.parameters.empty()) return Oracle::Begin(world);
    return info_.setup.as_shipped ? oracle_.BeginAsShipped(world) : oracle_.Begin(world);
  }
  std::unique_ptr<Simulation> BeginAsShipped(const World& world) const override {
    return info_.parameters.empty() ? oracle_.BeginAsShipped(world)
                                    : Oracle::BeginAsShipped(world);
  }
  std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                             int threads) const override {
    return oracle_.BeginInThreads(world, threads);
  }
  Trajectory Simulate(const World& world) const override {
    return info_.HasSetups() ? Oracle::Simulate(world) : oracle_.Simulate(world);
  }
  std::unique_ptr<Oracle> SetUp(const WorldSetup& setup) const override {
    return oracle_.SetUp(setup);
  }

 private:
  const Oracle& oracle_;
  OracleInfo info_;
};

}  // namespace

std::vector<double> ValuesOf(std::span<const WorldParameter> parameters,
                             const WorldSetup& setup) {
  std::vector<double> values;
  for (const WorldParameter& parameter : parameters) {
    const auto chosen = setup.chosen.find(parameter.name);
    values.push_back(chosen != setup.chosen.end() ? chosen->second
                     : setup.as_shipped           ? parameter.shipped
                                                  : parameter.here);
  }
  return values;
}

std::string Refusal(const WorldParameter& parameter, double value) {
  const bool fits = value >= parameter.least && value <= parameter.most &&
                    (!parameter.whole || value == std::floor(value));
  if (fits) return "";
  return fmt::format("a{} number from {} to {}", parameter.whole ? " whole" : "",
                     parameter.least, parameter.most);
}

std::string ToString(const WorldSetup& setup,
                     std::span<const WorldParameter> parameters) {
  std::string words = setup.as_shipped ? "as shipped" : "";
  for (const WorldParameter& parameter : parameters) {
    const auto chosen = setup.chosen.find(parameter.name);
    if (chosen == setup.chosen.end()) continue;
    words += fmt::format("{}{} = {} ({} as set here, {} as shipped)",
                         words.empty() ? "" : ", ", parameter.name, chosen->second,
                         parameter.here, parameter.shipped);
  }
  return words;
}

std::unique_ptr<Oracle> WithSetup(const Oracle& oracle, const WorldSetup& setup) {
  return std::make_unique<SetUpOracle>(oracle, setup);
}

}  // namespace touchstone
