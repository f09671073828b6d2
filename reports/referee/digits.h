#pragma once

#include "reports/referee/minkowski_difference.h"

namespace touchstone::referee {

/** Tells whether no double lies between the bounds: more digits could only prove that the
 number is one of them. */
bool IsTight(const Enclosure& length);

/** Tells whether a separation that was proved in `DoubleDouble` is left as it is. Its
 sign must be proved, and it must be tight; or its search is, or, among the faces of
 zonotopes, knows it to 2^-40 of itself, so that the rest, a few roundings of M, comes
 from the direction of the certificate, which is rounded to doubles whatever the digits;
 or it is that of a hull or a curved body, proved to 2^-40 of itself.
 @param searched The enclosure of the search, CoreTruth::separation.
 @param proved The enclosure of Proved(). */
bool IsFinal(const Enclosure& searched, const Enclosure& proved,
             const MinkowskiDifference& M);

}  // namespace touchstone::referee
