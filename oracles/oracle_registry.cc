#include "oracles/oracle_registry.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "oracles/bullet/bullet_oracles.h"
#include "oracles/cookbook/cookbook_batch_oracle.h"
#include "oracles/cookbook/cookbook_oracle.h"
#include "oracles/cookbook/printed_oracle.h"
#include "oracles/dart/dart_oracles.h"
#include "oracles/fcl/fcl_oracles.h"
#include "oracles/libccd/ccd_oracles.h"
#include "oracles/mujoco/mujoco_oracles.h"
#include "oracles/ode/ode_oracles.h"
#include "oracles/stated_tolerance.h"

namespace touchstone {
namespace {

using Oracles = std::vector<std::unique_ptr<Oracle>>;

Oracles Cookbook() {
  Oracles oracles;
  oracles.push_back(std::make_unique<CookbookOracle>());
  oracles.push_back(std::make_unique<CookbookBatchOracle>());
  oracles.push_back(std::make_unique<CookbookOracle>(CookbookSetup::kSleeping));
  oracles.push_back(MakePrintedOracle("printed"));
  return oracles;
}

// An adapter that is not built has a header but no library. A call that `if constexpr`
// discards needs no definition.

Oracles BulletDouble() {
  if constexpr (TOUCHSTONE_HAS_BULLET_DOUBLE) {
    return BulletOracles(BulletPrecision::kDouble);
  }
  return {};
}

Oracles BulletFloat() {
  if constexpr (TOUCHSTONE_HAS_BULLET_FLOAT) {
    return BulletOracles(BulletPrecision::kFloat);
  }
  return {};
}

Oracles Ode() {
  if constexpr (TOUCHSTONE_HAS_ODE) return OdeOracles();
  return {};
}

Oracles Fcl() {
  if constexpr (TOUCHSTONE_HAS_FCL) return FclOracles();
  return {};
}

Oracles Ccd() {
  if constexpr (TOUCHSTONE_HAS_CCD) return CcdOracles();
  return {};
}

Oracles Dart() {
  if constexpr (TOUCHSTONE_HAS_DART) return DartOracles();
  return {};
}

Oracles Mujoco() {
  if constexpr (TOUCHSTONE_HAS_MUJOCO) return MujocoOracles();
  return {};
}

/** One adapter, whether it is in this build or not. */
struct Adapter {
  std::string name;  ///< The common start of its oracles' names.
  bool built;
  std::string library;  ///< The engine's name for messages.
  std::string package;  ///< The Debian package that a build needs.
  Oracles (*make)();    ///< Throws std::runtime_error if its module does not load.
};

std::vector<Adapter> Adapters() {
  return {
      {"cookbook", true, "", "", Cookbook},
      {"bullet", TOUCHSTONE_HAS_BULLET_DOUBLE, "Bullet (double)", "libbullet-dev",
       BulletDouble},
      {"bullet_float", TOUCHSTONE_HAS_BULLET_FLOAT, "Bullet (float)", "libbullet-dev",
       BulletFloat},
      {"ode", TOUCHSTONE_HAS_ODE, "ODE", "libode-dev", Ode},
      {"fcl", TOUCHSTONE_HAS_FCL, "FCL", "libfcl-dev", Fcl},
      {"libccd", TOUCHSTONE_HAS_CCD, "libccd", "libccd-dev", Ccd},
      {"dart", TOUCHSTONE_HAS_DART, "DART", "libdart-dev", Dart},
      {"mujoco", TOUCHSTONE_HAS_MUJOCO, "MuJoCo", "libmujoco-dev", Mujoco},
  };
}

bool IsBelow(std::string_view name, std::string_view pattern) {
  return name.size() > pattern.size() && name.starts_with(pattern) &&
         name[pattern.size()] == '/';
}

}  // namespace

OracleRegistry OracleRegistry::BuiltIn() {
  OracleRegistry registry;
  for (const Adapter& adapter : Adapters()) {
    if (!adapter.built) {
      registry.missing_.push_back(
          {adapter.name, adapter.library +
                             " was not found by this build: apt-get install " +
                             adapter.package + ", then configure and build again"});
      continue;
    }
    try {
      for (auto& oracle : adapter.make()) registry.Add(std::move(oracle));
    } catch (const std::runtime_error& error) {
      registry.missing_.push_back({adapter.name, error.what()});
    }
  }
  registry.specimens_ =
      std::make_unique<Specimens>();  // Last, because Add() uses Find().
  return registry;
}

void OracleRegistry::Add(std::unique_ptr<Oracle> oracle) {
  const std::string& name = oracle->info().name;
  if (Find(name) != nullptr) {
    throw std::invalid_argument("an oracle named \"" + name + "\" already exists");
  }
  const auto last = std::find_if(
      oracles_.rbegin(), oracles_.rend(),
      [&](const auto& other) { return other->info().library == oracle->info().library; });
  oracles_.insert(last == oracles_.rend() ? oracles_.end() : last.base(),
                  std::move(oracle));
}

void OracleRegistry::AddMissing(MissingOracle missing) {
  if (Find(missing.name) == nullptr) missing_.push_back(std::move(missing));
}

template <typename Change>
void OracleRegistry::Replace(std::string_view name, Change change) {
  const auto replace = [&](std::unique_ptr<Oracle>& oracle) {
    std::unique_ptr<Oracle> changed = change(*oracle);
    replaced_.push_back(std::exchange(oracle, std::move(changed)));
  };
  for (std::unique_ptr<Oracle>& oracle : oracles_) {
    if (oracle->info().name == name) return replace(oracle);
  }
  if (FindSpecimen(name) == nullptr) return;
  const std::lock_guard lock(specimens_->mutex);
  replace(specimens_->by_name.find(name)->second);
}

void OracleRegistry::SetTolerance(std::string_view name,
                                  const StatedTolerance& tolerance) {
  Replace(name, [&](const Oracle& oracle) { return WithTolerance(oracle, tolerance); });
}

void OracleRegistry::SetUp(std::string_view name, const WorldSetup& setup) {
  const Oracle* oracle = Find(name);
  if (oracle == nullptr || !oracle->info().simulates) return;
  Replace(name, [&](const Oracle& replaced) { return replaced.SetUp(setup); });
}

const Oracle* OracleRegistry::Find(std::string_view name) const {
  for (const std::unique_ptr<Oracle>& oracle : oracles_) {
    if (oracle->info().name == name) return oracle.get();
  }
  return FindSpecimen(name);
}

const Oracle* OracleRegistry::FindSpecimen(std::string_view name) const {
  if (specimens_ == nullptr) return nullptr;
  const std::lock_guard lock(specimens_->mutex);
  auto& by_name = specimens_->by_name;
  auto found = by_name.find(name);
  if (found == by_name.end()) {
    std::unique_ptr<Oracle> specimen = MakePrintedOracle(name);
    if (specimen == nullptr) return nullptr;
    found = by_name.emplace(name, std::move(specimen)).first;
  }
  return found->second.get();
}

std::vector<const Oracle*> OracleRegistry::Matching(std::string_view pattern) const {
  std::vector<const Oracle*> matching;
  for (const std::unique_ptr<Oracle>& oracle : oracles_) {
    const std::string& name = oracle->info().name;
    if (name == pattern || IsBelow(name, pattern)) matching.push_back(oracle.get());
  }
  return matching;
}

bool OracleRegistry::MayExist(std::string_view name) const {
  const auto is_it = [name](const MissingOracle& missing) {
    return name == missing.name || IsBelow(name, missing.name);
  };
  return Find(name) != nullptr || std::any_of(missing_.begin(), missing_.end(), is_it);
}

std::vector<const Oracle*> OracleRegistry::All() const {
  std::vector<const Oracle*> all;
  for (const std::unique_ptr<Oracle>& oracle : oracles_) all.push_back(oracle.get());
  return all;
}

std::vector<std::string> OracleRegistry::SpecimenNames() const {
  return specimens_ == nullptr ? std::vector<std::string>() : PrintedOracleNames();
}

}  // namespace touchstone
