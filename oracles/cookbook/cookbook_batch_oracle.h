#pragma once

#include "oracles/oracle.h"

namespace touchstone {

/** Box against box and sphere against sphere as the cookbook engine's batches see them:
 many pairs in one call, with the widest vectors of the processor. The verdict, the depth
 and the normal, no contacts; everything else is unsupported. Of spheres apart it gives
 the distance, of boxes apart only the normal of the plane between them. */
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
