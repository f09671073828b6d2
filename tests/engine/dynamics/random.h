#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <Eigen/Geometry>

namespace cookbook {

/** Random numbers for property tests, with the same values on every platform. */
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  double Uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  double LogUniform(double low, double high) {
    return std::exp(Uniform(std::log(low), std::log(high)));
  }
  int Below(int count) { return static_cast<int>(Uniform(0, count)); }
  bool Coin() { return Uniform(0, 1) < 0.5; }
  Eigen::Vector3d Direction() {
    const double z = Uniform(-1, 1);
    const double angle = Uniform(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  Eigen::Quaterniond Rotation() {
    const double angle = Uniform(0, 6);
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Direction()));
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace cookbook
