#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oracles/function_oracle.h"
#include "oracles/oracle.h"

namespace touchstone {

/** Starts a world in a user's engine. It may be called from several threads at once. An
 exception, here or in a step, becomes AnswerStatus::kCrashed. */
using BeginFunction = std::function<std::unique_ptr<Simulation>(const World&)>;

/** The promises of the author of a world engine. */
struct SimulatorPromises {
  /** The features that it simulates beyond gravity and free motion. A world that needs
   anything else is unsupported. */
  std::vector<WorldFeature> simulates = {};
  Precision precision = Precision::kDouble;
  /** The depth that the engine leaves between bodies in contact on purpose. Laws about
   depths and places grant it; the report says so. [m] */
  double slop = 0;
  std::string documented_by = {};  ///< Where the slop is documented.
};

/** Returns every feature of worlds except `cannot`, for SimulatorPromises::simulates. */
std::vector<WorldFeature> EverythingExcept(const std::vector<WorldFeature>& cannot);

/** Returns an oracle that simulates worlds with what `begin` returns.
 @throws std::invalid_argument for a slop that is negative, not finite, or documented
 nowhere. */
std::unique_ptr<Oracle> MakeSimulator(std::string name, BeginFunction begin,
                                      const SimulatorPromises& promises);

/** Returns an oracle whose worlds are of type `Engine`, a Simulation that is constructed
 from a `const World&`. The world outlives it:
      MakeSimulator<MyWorld>("mine", {.simulates = {WorldFeature::kSphere}}) */
template <typename Engine>
std::unique_ptr<Oracle> MakeSimulator(std::string name,
                                      const SimulatorPromises& promises) {
  return MakeSimulator(
      std::move(name), [](const World& world) { return std::make_unique<Engine>(world); },
      promises);
}

}  // namespace touchstone
