#pragma once

#include "reports/run_report.h"

namespace touchstone {

/** Returns the time of the motions of all worlds of all oracles, by kind of motion; see
 WorldSeconds::motions. [s] */
SecondsByName SecondsOfMotions(const RunReport& report);

/** Returns the time of the judgement of all of them, by law. [s] */
SecondsByName SecondsOfLaws(const RunReport& report);

}  // namespace touchstone
