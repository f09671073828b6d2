#pragma once

#include "oracles/cookbook/cookbook_world.h"
#include "oracles/oracle.h"

namespace touchstone {

/** The corrected cookbook engine: contact queries on spheres and boxes, one after the
 other, and worlds of them.

 The engine uses the project's conventions, so nothing is converted. For boxes apart it
 finds a separating axis but not the distance: the answer has the normal and no
 separation. */
class CookbookOracle final : public Oracle {
 public:
  explicit CookbookOracle(CookbookSetup setup = CookbookSetup::kAwake);

  const OracleInfo& info() const override { return info_; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override;
  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override;
  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override;
  std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                             int threads) const override;
  /** Unlike the default, the threads of BeginInThreads() have the setup, too. */
  std::unique_ptr<Oracle> SetUp(const WorldSetup& setup) const override;

 private:
  /** Sets what info() documents about sleep, from the parameters in force. */
  void DescribeSleep();

  OracleInfo info_;
};

}  // namespace touchstone
