#pragma once

#include <memory>
#include <span>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** Another oracle under the same name. Everything but info() is forwarded to it;
 subclasses change the description and what goes with it. */
class ForwardingOracle : public Oracle {
 public:
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
    return oracle_.Begin(world);
  }
  std::unique_ptr<Simulation> BeginAsShipped(const World& world) const override {
    return oracle_.BeginAsShipped(world);
  }
  std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                             int threads) const override {
    return oracle_.BeginInThreads(world, threads);
  }
  std::unique_ptr<Oracle> SetUp(const WorldSetup& setup) const override {
    return oracle_.SetUp(setup);
  }
  Trajectory Simulate(const World& world) const override {
    return oracle_.Simulate(world);
  }
  std::vector<Trajectory> SimulateEach(std::span<const World> worlds) const override {
    return oracle_.SimulateEach(worlds);
  }

 protected:
  /** @param oracle Must live longer. */
  explicit ForwardingOracle(const Oracle& oracle)
      : oracle_(oracle), info_(oracle.info()) {}

  const Oracle& oracle_;
  OracleInfo info_;  ///< A copy of the oracle's, for subclasses to change.
};

}  // namespace touchstone
