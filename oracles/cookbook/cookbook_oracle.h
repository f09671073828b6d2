#pragma once

#include "oracles/oracle.h"

namespace touchstone {

/** The corrected cookbook engine: spheres and boxes, one query after the other, and
 worlds of them.

 The engine speaks the project's conventions, so that nothing is converted. Of boxes apart
 it knows an axis that separates them, not their distance: the answer has the normal and
 no separation. */
class CookbookOracle final : public Oracle {
 public:
  CookbookOracle();

  const OracleInfo& info() const override { return info_; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override;
  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override;
  std::unique_ptr<Simulation> Begin(const World& world) const override;
  std::unique_ptr<Simulation> BeginAsShipped(const World& world) const override;
  std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                             int threads) const override;

 private:
  OracleInfo info_;
};

}  // namespace touchstone
