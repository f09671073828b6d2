#include "oracles/oracle.h"

#include <algorithm>

#include "oracles/no_answer.h"
#include "oracles/standard_arithmetic.h"
#include "oracles/stopwatch.h"

namespace touchstone {

std::unique_ptr<PreparedBatch> Oracle::Prepare(std::span<const ContactQuery>) const {
  return nullptr;
}

bool OracleInfo::AnswersContacts() const {
  return std::any_of(capabilities.begin(), capabilities.end(), [](const auto& of_A) {
    return std::any_of(of_A.begin(), of_A.end(),
                       [](const Capability& capability) { return capability.supported; });
  });
}

std::string OracleInfo::CannotSimulate(const World& world) const {
  if (!simulates) return "answers contact queries only";
  for (const WorldFeature feature : FeaturesOf(world)) {
    if (!For(feature).supported) return For(feature).reason;
  }
  return "";
}

double SoftnessOf(const OracleInfo& oracle) {
  if (oracle.softness.empty()) return 0;
  const std::vector<double> values = ValuesOf(oracle.parameters, oracle.setup);
  const auto found =
      std::ranges::find(oracle.parameters, oracle.softness, &WorldParameter::name);
  return values.at(static_cast<std::size_t>(found - oracle.parameters.begin()));
}

std::string Oracle::CannotSimulate(const World& world) const {
  return info().CannotSimulate(world);
}

std::unique_ptr<Simulation> Oracle::BeginWith(const World&,
                                              std::span<const double>) const {
  return nullptr;
}

std::unique_ptr<Simulation> Oracle::Begin(const World& world) const {
  return BeginWith(world, ValuesOf(info().parameters, info().setup));
}

std::unique_ptr<Simulation> Oracle::BeginAsShipped(const World& world) const {
  if (info().parameters.empty()) return Begin(world);
  WorldSetup setup = info().setup;
  setup.as_shipped = true;
  return BeginWith(world, ValuesOf(info().parameters, setup));
}

std::unique_ptr<Oracle> Oracle::SetUp(const WorldSetup& setup) const {
  return WithSetup(*this, setup);
}

std::unique_ptr<Simulation> Oracle::BeginInThreads(const World&, int) const {
  return nullptr;
}

Trajectory Oracle::Simulate(const World& world) const {
  Trajectory trajectory;
  trajectory.reason = CannotSimulate(world);
  if (!trajectory.reason.empty()) return trajectory;
  const StandardArithmetic arithmetic;
  const Stopwatch watch;
  try {
    trajectory = RunToEnd(*Begin(world), world);
  } catch (...) {
    const ContactAnswer crash = CrashedByException();
    trajectory.status = crash.status;
    trajectory.reason = crash.reason;
  }
  trajectory.seconds = watch.seconds();
  return trajectory;
}

std::vector<Trajectory> Oracle::SimulateEach(std::span<const World> worlds) const {
  std::vector<Trajectory> trajectories;
  trajectories.reserve(worlds.size());
  for (const World& world : worlds) trajectories.push_back(Simulate(world));
  return trajectories;
}

ContactAnswer Oracle::Answer(const ContactQuery& query) const {
  ContactAnswer answer;
  Answer(std::span(&query, 1), std::span(&answer, 1));
  return answer;
}

}  // namespace touchstone
