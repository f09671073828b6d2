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
 polynomial of few short integers: it is 0, or not as near to 0 as 2^-200 of the scene.
 Empty if the enclosure of the truth is wider than that.
 @pre IsExactScene(query, 2^-53). */
std::optional<bool> TouchingInExactScene(const ContactQuery& query,
                                         const ContactTruth& truth);

}  // namespace touchstone
