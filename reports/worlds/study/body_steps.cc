#include "reports/worlds/study/body_steps.h"

namespace touchstone {

bool IsStudied(const WorldScenario& scenario) {
  return BodySteps(scenario.world) <= kStudiedBodySteps;
}

}  // namespace touchstone
