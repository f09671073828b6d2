#pragma once

#include <string>
#include <vector>

#include "scenarios/contact_query.h"
#include "scenarios/measure_kind.h"

namespace touchstone {

// Arbitrary parts of scenarios, of RapidCheck's current case.

/** Any finite double: every exponent is as likely, denormals and -0 among them. */
double AnyNumber();

/** Any length that a question may have. */
double AnyLength();

Eigen::Vector3d AnyPoint();

/** Any point that a question may have. */
Eigen::Vector3d AnyPlace();

/** A component of a direction, dense enough to need 17 digits. */
double AnyComponent();

/** Any letters of ASCII, none of them left out, and some of Unicode. */
std::string AnyText();

/** One measure or more. */
std::vector<MeasureKind> AnyMeasures();

Pose AnyPose();

/** `bounded`: no half-space. */
Shape AnyShape(bool bounded);

}  // namespace touchstone
