#pragma once

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** A query in a unit of length that is a power of two metres, about the size of the
 bodies and their distance. Its lengths are those of the original exactly, but their
 fourth powers neither overflow nor underflow, whatever the size in metres. */
struct UnitScale {
  ContactQuery query;  ///< Lengths in units of 2^exponent m.
  int exponent;
};

/** Returns `query` in its own unit.
 @pre Its lengths are valid (scenarios/validate.h), and neither body is a half-space. */
UnitScale InOwnUnit(const ContactQuery& query);

/** Returns the enclosure in metres of a length in units of 2^exponent m. [m] */
Enclosure InMetres(const Enclosure& length, int exponent);

/** Returns the length in metres of one in units of 2^exponent m. [m] */
Eigen::Vector3d InMetres(const Eigen::Vector3d& length, int exponent);

}  // namespace touchstone::referee
