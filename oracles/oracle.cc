#include "oracles/oracle.h"

#include "oracles/no_answer.h"

namespace touchstone {

std::unique_ptr<PreparedBatch> Oracle::Prepare(std::span<const ContactQuery>) const {
  return nullptr;
}

std::string OracleInfo::CannotSimulate(const World& world) const {
  if (!simulates) return "answers contact queries only";
  for (const WorldFeature feature : FeaturesOf(world)) {
    if (!For(feature).supported) return For(feature).reason;
  }
  return "";
}

std::unique_ptr<Simulation> Oracle::Begin(const World&) const {
  return nullptr;
}

Trajectory Oracle::Simulate(const World& world) const {
  Trajectory trajectory;
  trajectory.reason = info().CannotSimulate(world);
  if (!trajectory.reason.empty()) return trajectory;
  try {
    return RunToEnd(*Begin(world), world);
  } catch (...) {
    const ContactAnswer crash = CrashedByException();
    trajectory.status = crash.status;
    trajectory.reason = crash.reason;
    return trajectory;
  }
}

ContactAnswer Oracle::Answer(const ContactQuery& query) const {
  ContactAnswer answer;
  Answer(std::span(&query, 1), std::span(&answer, 1));
  return answer;
}

}  // namespace touchstone
