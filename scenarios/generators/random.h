#pragma once

#include <cstdint>
#include <initializer_list>

#include <Eigen/Geometry>

namespace touchstone {

/** A random number generator that is the same on every machine. The n-th number is a pure
 function of the key and n, computed only with integer arithmetic, exact conversions,
 + − × ÷ and √.

 SplitMix64: Steele, Lea & Flood, "Fast splittable pseudorandom number generators", OOPSLA
 2014, figures 16 and 17. It does not use the distributions of <random>, which differ
 between standard libraries, nor libm functions other than sqrt, which differ in the last
 bit. */
class Random {
 public:
  explicit Random(std::initializer_list<std::uint64_t> key);

  /** Returns 64 random bits. */
  std::uint64_t Bits();

  /** Returns a multiple of 2^-53 in [0, 1). */
  double Uniform();

  /** Returns a number in [lo, hi], uniform up to rounding. */
  double Uniform(double lo, double hi);

  /** Returns an integer in [0, n). @pre 0 < n < 2^31. */
  int Below(int n);

  /** Returns true with probability 1/2. */
  bool Coin() { return Below(2) == 0; }

  /** Returns −1 or +1. */
  double Sign() { return Coin() ? -1 : 1; }

  /** Returns a magnitude in [10^lo, 10^hi): all decades are equally likely, and it is
   uniform within a decade. @pre −16 <= lo < hi <= 16. */
  double Decades(int lo, int hi);

  /** Returns a unit vector; all directions are equally likely. */
  Eigen::Vector3d Direction();

  /** Returns a unit vector (cos φ, sin φ); all φ are equally likely. */
  Eigen::Vector2d PlaneDirection();

  /** Returns a unit quaternion; all rotations are equally likely. */
  Eigen::Quaterniond Rotation();

 private:
  std::uint64_t state_ = 0;
};

}  // namespace touchstone
