#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/referee/contact_truth.h"

namespace touchstone {

/** Returns points that span a patch of `query` along the unit normal n_W [m]: its
 corners, drawn to its middle in steps of 2 % until both bodies, which overlap by
 −`separation`, reach there to within `reached`. The polygon around a disc is 2 % wider
 than the disc. A rim and an edge meet in a point whose place along the edge is known only
 to the root of a rounding: there may be none. */
std::vector<Eigen::Vector3d> ReachedCorners(const ContactQuery& query,
                                            const ContactPatch& patch,
                                            const Eigen::Vector3d& n_W, double separation,
                                            double reached);

/** Returns the right answer to `query`, made from the certified truth. It has every field
 that an oracle can return, and contacts that span the true patch. Unsupported if no point
 of the patch is known well enough. */
ContactAnswer RightAnswer(const ContactQuery& query);

/** An oracle made from a function, so that tests can plant an error. */
class FakeOracle : public Oracle {
 public:
  using Function = std::function<ContactAnswer(const ContactQuery&)>;

  /** Makes an oracle that supports and promises everything, in double precision. */
  explicit FakeOracle(std::string name, Function function = RightAnswer);

  /** Returns an oracle that answers correctly except for the change that `plant` makes to
   its answer. */
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
