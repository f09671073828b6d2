#pragma once

#include "reports/worlds/study/study.h"
#include "tests/reports/worlds/fake_simulator.h"

namespace touchstone {

WorldScenario TwoBallsInFlight();

/** The motion at the step of the world, a half and a quarter of it. */
struct Studied {
  Studied(const WorldScenario& s, const FakeSimulator& oracle);
  Study study() const { return {scenario, info, whole, &half, &quarter}; }

  WorldScenario scenario;
  OracleInfo info;
  Trajectory whole;
  Trajectory half;
  Trajectory quarter;
};

/** An engine whose positions are off by `scale` h^order t along (1, 2, −1). */
FakeSimulator OffBy(double scale, double order);

}  // namespace touchstone
