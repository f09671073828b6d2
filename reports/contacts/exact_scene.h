#pragma once

#include <optional>

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns whether the numbers of `query` are so short that an arithmetic of unit
 roundoff `u` computes with them without rounding: both rotations map axes to axes, and
 all positions and sizes are multiples of one power of two, by integers of so few bits
 that sums, differences, and sums of products of two of them are exact. Whether such
 bodies touch is decided even where they are exactly flush. */
bool IsExactScene(const ContactQuery& query, double u);

/** Returns whether the shapes of an exact scene touch. Its separation is a root of a
 polynomial of few short integers: its magnitude is 0 or more than 2^-200 of the scene's
 size. Empty if the enclosure of the truth is wider than that.
 @pre IsExactScene(query, 2^-53). */
std::optional<bool> TouchingInExactScene(const ContactQuery& query,
                                         const ContactTruth& truth);

}  // namespace touchstone
