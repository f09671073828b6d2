#pragma once

#include <cstdint>
#include <initializer_list>

#include <Eigen/Geometry>

namespace touchstone {

/** Random numbers that are the same on every machine: the n-th is a pure function of the
 key and n, made of integer arithmetic, exact conversions, + − × ÷ and √ alone.

 SplitMix64: Steele, Lea & Flood, "Fast splittable pseudorandom number generators", OOPSLA
 2014, figures 16 and 17. Nothing of <random>'s distributions, which differ between
 standard libraries, nor of libm's functions other than sqrt, which differ in the last
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

  /** Returns true in one case of two. */
  bool Coin() { return Below(2) == 0; }

  /** Returns −1 or +1. */
  double Sign() { return Coin() ? -1 : 1; }

  /** Returns a magnitude in [10^lo, 10^hi): every decade is as likely, uniform within it.
   @pre −16 <= lo < hi <= 16. */
  double Decades(int lo, int hi);

  /** Returns a unit vector, every direction as likely. */
  Eigen::Vector3d Direction();

  /** Returns a unit vector (cos φ, sin φ), every φ as likely. */
  Eigen::Vector2d PlaneDirection();

  /** Returns a unit quaternion, every rotation as likely. */
  Eigen::Quaterniond Rotation();

 private:
  std::uint64_t state_ = 0;
};

}  // namespace touchstone
