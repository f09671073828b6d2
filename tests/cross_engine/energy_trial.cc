// Asks an engine for random worlds in which nothing adds energy, and looks for gains.
//
//     energy_trial [COUNT [SEED [ENGINE]]]
//
// Simulates COUNT worlds of each family with ENGINE (cookbook), and prints how many of
// them have more energy at any step than at the start. The gain is a fraction of the
// largest sum so far of the kinetic energy and, for each body, its weight times the sum
// of its way from the start and its radius. Returns 1 if a gain exceeds 1e-9, if a motion
// is missing that the engine claims to simulate, or if it simulates none.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "oracles/oracle_registry.h"
#include "reports/threads/parallel_for.h"
#include "reports/worlds/study/every_step.h"
#include "scenarios/generators/worlds/world_family.h"

namespace touchstone {
namespace {

/** The most that a motion may gain. [-] */
constexpr double kMost = 1e-9;

constexpr std::array kLimits = {1e-15, 1e-12, kMost, 1e-6, 1e-3};

/** The motion of one world. */
struct Gain {
  bool is_asked = false;  ///< Whether the engine claims to simulate the world.
  bool is_answered = false;
  double gain = 0;  ///< As a fraction of the energy. [-]
};

/** The energy of a world without springs and cloths. */
struct Energy {
  double total = 0;  ///< Kinetic, and potential relative to the start. [J]
  double size = 0;   ///< The sum of which a gain is a fraction. [J]
};

void Add(double mass, const Eigen::Vector3d& v_W, const Eigen::Vector3d& way_W,
         const World& world, Energy& energy) {
  const double kinetic = 0.5 * mass * v_W.squaredNorm();
  energy.total += kinetic - mass * world.gravity_W.dot(way_W);
  energy.size += kinetic + mass * world.gravity_W.norm() * way_W.norm();
}

Energy EnergyAt(const World& world, const WorldState& state) {
  Energy energy;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& body = world.bodies[i];
    if (body.mass == 0) continue;
    const BodyState& at = state.bodies[i];
    const Eigen::Vector3d w_B = at.q_WB.normalized().conjugate() * at.w_WB;
    const double turning = 0.5 * w_B.dot(InertiaOf(body).cwiseProduct(w_B));
    energy.total += turning;
    energy.size +=
        turning + body.mass * world.gravity_W.norm() * BoundingRadius(body.placed.shape);
    Add(body.mass, at.v_WB, at.p_WB - body.placed.X_WB.p_WB, world, energy);
  }
  for (std::size_t i = 0; i < world.particles.size(); ++i) {
    const PointState& at = state.particles[i];
    Add(world.particles[i].mass, at.v_W, at.p_W - world.particles[i].p_W, world, energy);
  }
  return energy;
}

Gain GainOf(const Oracle& oracle, const World& world) {
  if (!oracle.info().CannotSimulate(world).empty()) return {};
  const Trajectory motion = oracle.Simulate(EveryStep(world));
  if (motion.status != AnswerStatus::kAnswered || motion.diverged_at_step > 0)
    return {.is_asked = true};
  const double start = EnergyAt(world, motion.samples.front()).total;
  Gain gain{.is_asked = true, .is_answered = true};
  double size = 0;
  for (const WorldState& state : motion.samples) {
    const Energy energy = EnergyAt(world, state);
    size = std::max(size, energy.size);
    if (energy.total > start)
      gain.gain = std::max(gain.gain, (energy.total - start) / size);
  }
  return gain;
}

/** The motions of one family, or of all. */
struct Summary {
  int asked = 0;
  bool is_right = true;  ///< Whether no motion gains too much or is missing.
};

/** Prints a row of the table. */
Summary Report(WorldFamily family, const std::vector<Gain>& gains) {
  std::string row = fmt::format("{:<14}", NameOf(family));
  std::size_t worst = 0;
  int asked = 0;
  int answered = 0;
  for (std::size_t i = 0; i < gains.size(); ++i) {
    asked += gains[i].is_asked;
    answered += gains[i].is_answered;
    if (gains[i].gain > gains[worst].gain) worst = i;
  }
  row += fmt::format("{:>9}{:>9}", asked, answered);
  for (const double limit : kLimits)
    row += fmt::format("{:>9}", std::ranges::count_if(gains, [&](const Gain& gain) {
                         return gain.gain > limit;
                       }));
  std::puts(
      fmt::format("{}   {:.2g} in world {}", row, gains[worst].gain, worst).c_str());
  return {asked, answered == asked && gains[worst].gain <= kMost};
}

int Try(int count, std::uint64_t seed, const Oracle& oracle) {
  std::string heading = fmt::format("{:<14}{:>9}{:>9}", "family", "asked", "answered");
  for (const double limit : kLimits)
    heading += fmt::format("{:>9}", fmt::format(">{:g}", limit));
  std::puts((heading + "   most").c_str());
  Summary all;
  for (const WorldFamily family : AllWorldFamilies()) {
    std::vector<Gain> gains(static_cast<std::size_t>(count));
    ParallelFor(gains.size(), 0, [&](std::size_t i) {
      gains[i] = GainOf(oracle, GenerateWorld(family, seed, i).world);
    });
    const Summary summary = Report(family, gains);
    all.asked += summary.asked;
    all.is_right &= summary.is_right;
  }
  return all.is_right && all.asked > 0 ? 0 : 1;
}

}  // namespace
}  // namespace touchstone

int main(int argc, char** argv) {
  using namespace touchstone;
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const std::string name = argc > 3 ? argv[3] : "cookbook";
  const OracleRegistry registry = OracleRegistry::BuiltIn();
  const Oracle* oracle = registry.Find(name);
  if (oracle == nullptr || count < 1) {
    std::fputs("usage: energy_trial [COUNT [SEED [ENGINE]]]\n", stderr);
    return 2;
  }
  return Try(count, seed, *oracle);
}
