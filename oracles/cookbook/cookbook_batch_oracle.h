#pragma once

#include "oracles/oracle.h"

namespace touchstone {

/** The batch queries of the cookbook engine, for pairs of boxes and pairs of spheres:
 many pairs in one call, with the widest vectors of the processor. They return the
 verdict, the depth and the normal, but no contacts. For separated spheres they also
 return the distance, for separated boxes only the normal of a separating plane. All other
 pairs are unsupported. */
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
