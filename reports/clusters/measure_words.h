#pragma once

#include <string_view>

#include "scenarios/measure_kind.h"

namespace touchstone {

/** Returns what an oracle does that errs in a measure, as a predicate in plain words:
 "states a wrong distance or depth". */
std::string_view FaultInWords(MeasureKind measure);

}  // namespace touchstone
