#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace touchstone {

/** A set of block numbers, as disjoint ranges. */
class BlockSet {
 public:
  /** Adds the blocks `first` to `last`. Returns false, and adds nothing, if any of them
   is in the set already. @pre first <= last. */
  bool Add(std::uint64_t first, std::uint64_t last);

  bool Contains(std::uint64_t block) const;
  std::uint64_t size() const;

  /** Returns the first block in [0, count) that is not in the set; empty if all are. */
  std::optional<std::uint64_t> FirstMissing(std::uint64_t count) const;

  /** The ranges, from first to last block; adjacent ones are joined. */
  const std::map<std::uint64_t, std::uint64_t>& ranges() const { return ranges_; }

 private:
  std::map<std::uint64_t, std::uint64_t> ranges_;
};

}  // namespace touchstone
