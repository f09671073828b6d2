#pragma once

#include <cstdint>
#include <map>

namespace touchstone {

/** A quantile sketch: a histogram with eight bins to each power of two. Any two values of
 a bin differ by at most an eighth of the smaller one. It is the linear-in-octave form of
 DDSketch (Masson, Rim & Lee, PVLDB 12, 2019): merging adds whole numbers, so the result
 depends on neither order nor grouping, and the bin of a value is the upper bits of the
 double, the same on every machine. */
class Sketch {
 public:
  /** A bin's number increases with the values in it. */
  using Bin = std::int64_t;

  /** Counts `value`: a negative one as 0, a NaN as infinite. */
  void Add(double value) { Add(BinOf(value), 1); }
  void Add(Bin bin, std::uint64_t count) { bins_[bin] += count; }
  void Merge(const Sketch& other);

  std::uint64_t count() const;
  const std::map<Bin, std::uint64_t>& bins() const { return bins_; }

  /** Returns the lower edge of the bin with the value of rank ceil(q n) among n values;
   0 if there are none. @pre 0 <= q <= 1. */
  double Quantile(double q) const;

  static Bin BinOf(double value);
  /** Returns the least value of a bin. */
  static double LeastOf(Bin bin);

  bool operator==(const Sketch&) const = default;

 private:
  std::map<Bin, std::uint64_t> bins_;
};

}  // namespace touchstone
