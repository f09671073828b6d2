#pragma once

#include "reports/worlds/study/study.h"
#include "tests/reports/worlds/fake_simulator.h"

namespace touchstone {

/** Returns a world of two balls in free flight that claims `ballistic`. */
WorldScenario TwoBallsInFlight();

/** The motions of a world at its step, and at half and a quarter of it. */
struct Studied {
  Studied(const WorldScenario& s, const FakeSimulator& oracle);
  Study study() const { return {scenario, info, whole, &half, &quarter}; }

  WorldScenario scenario;
  OracleInfo info;
  Trajectory whole;
  Trajectory half;
  Trajectory quarter;
};

/** Returns an engine whose positions are off by `scale` h^order t times (1, 2, −1). */
FakeSimulator OffBy(double scale, double order);

}  // namespace touchstone
