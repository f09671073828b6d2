#include "engine/dynamics/world/linked_islands.h"

namespace cookbook {

void LinkedIslands::Find(std::span<const PairSummary> pairs,
                         std::span<const DistanceJoint> joints,
                         std::span<const Spring> springs, std::span<const char> is_static,
                         const std::vector<bool>& linked) {
  is_static_ = is_static;
  islands_.Reset(is_static.size());
  const auto moves = [&](int body) {
    return body >= 0 && is_static[static_cast<std::size_t>(body)] == 0;
  };
  const auto unite = [&](int A, int B) {
    if (moves(A) && moves(B)) islands_.Unite(A, B);
  };
  for (const DistanceJoint& joint : joints) unite(joint.A.body, joint.B.body);
  for (const Spring& spring : springs) unite(spring.A.body, spring.B.body);
  for (const PairSummary& pair : pairs) {
    if (pair.count > 0) unite(pair.A, pair.B);
  }
  roots_ = islands_.Roots();
  is_linked_.assign(is_static.size(), 0);
  for (std::size_t i = 0; i < is_static.size(); ++i) {
    if (linked[i] && is_static[i] == 0)
      is_linked_[static_cast<std::size_t>(roots_[i])] = 1;
  }
  linked_pairs_.assign(pairs.begin(), pairs.end());
  other_pairs_.assign(pairs.begin(), pairs.end());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const bool is_linked =
        (moves(pairs[p].A) || moves(pairs[p].B)) && is_linked_[IslandOf(pairs[p])] != 0;
    (is_linked ? other_pairs_ : linked_pairs_)[p].count = 0;
  }
}

}  // namespace cookbook
