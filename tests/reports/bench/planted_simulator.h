#pragma once

#include <functional>
#include <memory>
#include <string>

#include "oracles/oracle.h"

namespace touchstone {

/** An oracle that moves every body by 1 m along x in each step. It calls a function in
 each step, so that a fault can be planted. */
class PlantedSimulator : public Oracle {
 public:
  /** Called with the number of threads and the number of the step, from 1 on. */
  using Deed = std::function<void(int threads, int step)>;

  explicit PlantedSimulator(std::string name, Deed deed = {});

  OracleInfo& info() { return info_; }

  using Oracle::Answer;
  const OracleInfo& info() const override { return info_; }
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override;
  std::unique_ptr<Simulation> Begin(const World& world) const override;
  std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                             int threads) const override;

 private:
  OracleInfo info_;
  Deed deed_;
};

/** Returns a world of one ball of 1 m that can move, above a static one. */
World TwoBalls();

}  // namespace touchstone
