#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

constexpr std::array<std::string_view, 3> kVectorKeys = {"position", "velocity", "spin"};

// In the order of MotionExpectation::what.
constexpr std::array<std::string_view, 7> kKeys = {
    "", "quaternion", "angle", "touches", "topples", "rests", "trajectory"};
constexpr std::array<std::string_view, 7> kTimeKeys = {"at", "at", "at", "at",
                                                       "by", "by", ""};

void AddUnlessFinite(std::string_view where, double value, std::vector<Fault>& faults) {
  if (std::isfinite(value)) return;
  faults.push_back({std::string(where), fmt::format("is {}", value), "a finite number"});
}

void AddUnlessDirection(const Eigen::Vector3d& along, std::vector<Fault>& faults) {
  // Written so that a NaN is a fault.
  if (along.allFinite() && along.norm() > 0) return;
  faults.push_back({"along", "has no direction", "three finite numbers, not all 0"});
}

/** Returns the faults of what is stated. */
struct FaultsOfStatement {
  std::string_view key;

  std::vector<Fault> operator()(const ExpectedVector& expected) const {
    std::vector<Fault> faults;
    for (int i = 0; i < 3; ++i)
      AddUnlessFinite(fmt::format("{}[{}]", key, i), expected.value[i], faults);
    if (expected.along) AddUnlessDirection(*expected.along, faults);
    return faults;
  }
  std::vector<Fault> operator()(const ExpectedOrientation& expected) const {
    const double norm = expected.q_WB.coeffs().norm();
    if (std::abs(norm - 1) <= kRotationSlack) return {};
    return {{std::string(key), fmt::format("has norm {}", norm), "a unit quaternion"}};
  }
  std::vector<Fault> operator()(const ExpectedAngle& expected) const {
    std::vector<Fault> faults;
    AddUnlessFinite(key, expected.angle, faults);
    AddUnlessDirection(expected.axis, faults);
    return faults;
  }
  template <class Other>
  std::vector<Fault> operator()(const Other&) const {
    return {};
  }
};

/** What a name stands for in a world. */
struct Named {
  bool exists = false;
  bool is_body = false;
  bool moves = false;
};

Named Find(const World& world, std::string_view name) {
  for (const RigidBody& body : world.bodies)
    if (body.name == name) return {true, true, body.mass > 0};
  for (const Particle& particle : world.particles)
    if (particle.name == name) return {true, false, particle.mass > 0};
  return {};
}

void AddFaultsOfNames(const World& world, const MotionExpectation& expectation,
                      std::vector<Fault>& faults) {
  const bool is_trajectory = std::holds_alternative<ExpectedTrajectory>(expectation.what);
  if (!expectation.body.empty() || !is_trajectory) {
    const Named named = Find(world, expectation.body);
    const auto* vector = std::get_if<ExpectedVector>(&expectation.what);
    const bool may_be_particle = is_trajectory ||
                                 std::holds_alternative<ExpectedRest>(expectation.what) ||
                                 (vector && vector->of != ExpectedVector::Of::kSpin);
    const std::string_view expected =
        may_be_particle ? "a body or particle that moves" : "a body that moves";
    if (!named.exists || !named.moves || !(named.is_body || may_be_particle)) {
      faults.push_back({"body",
                        fmt::format("is \"{}\", {}", expectation.body,
                                    !named.exists  ? "which the world does not have"
                                    : !named.moves ? "which never moves"
                                                   : "a particle, which has no rotation"),
                        std::string(expected)});
    }
  }
  const auto* touch = std::get_if<ExpectedTouch>(&expectation.what);
  if (!touch) return;
  if (!Find(world, touch->other).is_body || touch->other == expectation.body) {
    faults.push_back(
        {"touches", fmt::format("is \"{}\"", touch->other), "the name of another body"});
  }
}

}  // namespace

std::string_view KeyOf(const MotionExpectation& expectation) {
  if (const auto* vector = std::get_if<ExpectedVector>(&expectation.what))
    return kVectorKeys[static_cast<std::size_t>(vector->of)];
  return kKeys[expectation.what.index()];
}

std::string_view TimeKeyOf(const MotionExpectation& expectation) {
  return kTimeKeys[expectation.what.index()];
}

std::vector<Fault> FaultsOf(const MotionExpectation& expectation) {
  std::vector<Fault> faults =
      std::visit(FaultsOfStatement{KeyOf(expectation)}, expectation.what);
  if (!std::holds_alternative<ExpectedTopple>(expectation.what) &&
      !(expectation.tolerance > 0 && std::isfinite(expectation.tolerance))) {
    faults.push_back({"tolerance", fmt::format("is {}", expectation.tolerance),
                      "a finite number > 0"});
  }
  const std::string_view time = TimeKeyOf(expectation);
  if (!time.empty() && !(expectation.time >= 0 && std::isfinite(expectation.time))) {
    faults.push_back({std::string(time), fmt::format("is {}", expectation.time),
                      "a finite number >= 0"});
  }
  return faults;
}

std::vector<Fault> FaultsIn(const World& world, const MotionExpectation& expectation) {
  std::vector<Fault> faults;
  AddFaultsOfNames(world, expectation, faults);
  const std::string_view key = TimeKeyOf(expectation);
  const double end = world.steps * world.dt;
  const double spacing = world.dt * world.sample_every;
  const double samples = expectation.time / spacing;
  // An event may come at any time; a state is known at samples.
  const bool is_event = std::holds_alternative<ExpectedTouch>(expectation.what);
  if (!key.empty() && !(expectation.time <= end + kStepSlack * world.dt)) {
    faults.push_back({std::string(key), fmt::format("is {}", expectation.time),
                      fmt::format("a time up to the end at {} s", end)});
  } else if (!key.empty() && !is_event &&
             !(std::abs(samples - std::round(samples)) <= kStepSlack)) {
    faults.push_back({std::string(key), fmt::format("is {}", expectation.time),
                      fmt::format("a time of a sample, a multiple of {} s", spacing)});
  }
  return faults;
}

}  // namespace touchstone
