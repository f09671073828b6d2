#pragma once

#include "oracles/oracle.h"

namespace touchstone {

/** The batch calls of the cookbook engine, for box against box and sphere against sphere:
 many pairs in one call, with the widest SIMD vectors of the processor. It returns
 touching, the depth and the normal, but no contacts; every other pair of shapes is
 unsupported. For spheres apart it returns the distance, for boxes apart only the normal
 of a separating plane. */
class CookbookBatchOracle final : public Oracle {
 public:
  CookbookBatchOracle();

  const OracleInfo& info() const override { return info_; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override;
  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override;

 private:
  OracleInfo info_;
};

}  // namespace touchstone
