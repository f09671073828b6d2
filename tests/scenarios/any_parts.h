#pragma once

#include <string>
#include <vector>

#include "scenarios/contact_query.h"
#include "scenarios/measure_kind.h"

namespace touchstone {

// Arbitrary parts of scenarios, drawn from RapidCheck's current case.

/** Any finite double, including denormals and -0; all exponents are equally likely. */
double AnyNumber();

/** Any length that a query may have. */
double AnyLength();

Eigen::Vector3d AnyPoint();

/** Any point that a query may have. */
Eigen::Vector3d AnyPlace();

/** A component of a direction that needs 17 digits. */
double AnyComponent();

/** Any ASCII characters, including control characters, and some of Unicode. */
std::string AnyText();

/** One measure or more. */
std::vector<MeasureKind> AnyMeasures();

Pose AnyPose();

/** Any shape; not a half-space if `bounded`. */
Shape AnyShape(bool bounded);

}  // namespace touchstone
