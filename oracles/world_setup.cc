#include "oracles/world_setup.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "oracles/forwarding_oracle.h"

namespace touchstone {
namespace {

class SetUpOracle final : public ForwardingOracle {
 public:
  SetUpOracle(const Oracle& oracle, const WorldSetup& setup) : ForwardingOracle(oracle) {
    info_.setup = setup;
  }

  std::unique_ptr<Simulation> Begin(const World& world) const override {
    if (info_.HasSetups()) return Oracle::Begin(world);
    return info_.setup.as_shipped ? oracle_.BeginAsShipped(world) : oracle_.Begin(world);
  }
  std::unique_ptr<Simulation> BeginAsShipped(const World& world) const override {
    return info_.HasSetups() ? Oracle::BeginAsShipped(world)
                             : oracle_.BeginAsShipped(world);
  }
  Trajectory Simulate(const World& world) const override {
    return info_.HasSetups() ? Oracle::Simulate(world) : oracle_.Simulate(world);
  }
  std::vector<Trajectory> SimulateEach(std::span<const World> worlds) const override {
    return Oracle::SimulateEach(worlds);
  }
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
