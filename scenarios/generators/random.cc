#include "scenarios/generators/random.h"

#include <cmath>

#include "scenarios/generators/portable_math.h"

namespace touchstone {
namespace {

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio, odd

std::uint64_t Mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

// Powers of ten rounded by the compiler, since pow() may round differently on another
// machine.
constexpr double kPowersOfTen[] = {1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9,
                                   1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1,
                                   1e0,   1e1,   1e2,   1e3,   1e4,   1e5,   1e6,   1e7,
                                   1e8,   1e9,   1e10,  1e11,  1e12,  1e13,  1e14,  1e15};

}  // namespace

Random::Random(std::initializer_list<std::uint64_t> key) {
  for (const std::uint64_t part : key) state_ = Mix(state_ + kGolden) ^ Mix(part);
}

std::uint64_t Random::Bits() {
  return Mix(state_ += kGolden);
}

double Random::Uniform() {
  return static_cast<double>(Bits() >> 11) * 0x1p-53;
}

double Random::Uniform(double lo, double hi) {
  return lo + (hi - lo) * Uniform();
}

int Random::Below(int n) {
  // The high half of a product; its bias is below n / 2^32.
  return static_cast<int>(((Bits() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
}

double Random::Decades(int lo, int hi) {
  const int decade = lo + Below(hi - lo);
  return kPowersOfTen[decade + 16] * Uniform(1, 10);
}

Eigen::Vector3d Random::Direction() {
  // A point of the unit ball, projected. Points near the centre are rejected, since
  // rounding affects their direction.
  for (;;) {
    const double x = Uniform(-1, 1), y = Uniform(-1, 1), z = Uniform(-1, 1);
    const Eigen::Vector3d v(x, y, z);
    const double square = Dot(v, v);
    if (square <= 1 && square > 0.01) return v / std::sqrt(square);
  }
}

Eigen::Vector2d Random::PlaneDirection() {
  for (;;) {
    const double x = Uniform(-1, 1), y = Uniform(-1, 1);
    const double square = x * x + y * y;
    if (square <= 1 && square > 0.01) return Eigen::Vector2d(x, y) / std::sqrt(square);
  }
}

Eigen::Quaterniond Random::Rotation() {
  for (;;) {
    const double w = Uniform(-1, 1), x = Uniform(-1, 1), y = Uniform(-1, 1),
                 z = Uniform(-1, 1);
    const double square = w * w + x * x + y * y + z * z;
    if (square <= 1 && square > 0.01) return Unit(Eigen::Quaterniond(w, x, y, z));
  }
}

}  // namespace touchstone
