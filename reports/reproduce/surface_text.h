#pragma once

#include <string>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the definition of `double From{name}(const Vector& p)`: the signed distance of
 a point in the world from the surface of `body`, negative inside, in closed form. The
 program must define Vector, an array of three doubles. Throws CannotReproduce for a hull
 without volume, which has no inside. */
std::string SignedDistanceText(char name, const Body& body);

/** Returns the definitions of FromA() and FromB(). */
std::string SignedDistancesText(const ContactQuery& query);

}  // namespace touchstone
