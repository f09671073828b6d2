#pragma once

#include <functional>
#include <string>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the right answer to `query`, made from the certified truth: everything that an
 oracle can give, contacts at all corners of the true patch. */
ContactAnswer RightAnswer(const ContactQuery& query);

/** An oracle made of a function, so that an error can be planted. */
class FakeOracle : public Oracle {
 public:
  using Function = std::function<ContactAnswer(const ContactQuery&)>;

  /** Supports and promises everything, in double. */
  explicit FakeOracle(std::string name, Function function = RightAnswer);

  /** An oracle that answers rightly, but for what `plant` does to its answer. */
  static FakeOracle Wrong(std::string name,
                          std::function<void(const ContactQuery&, ContactAnswer&)> plant);

  using Oracle::Answer;
  const OracleInfo& info() const override { return info_; }
  OracleInfo& info() { return info_; }
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override;

  /** Applies `change` to the capabilities of every pair. */
  void ForEachPair(const std::function<void(Capability&)>& change);

 private:
  OracleInfo info_;
  Function function_;
};

}  // namespace touchstone
