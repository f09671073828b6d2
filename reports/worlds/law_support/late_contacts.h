#pragma once

#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns the distance by which two motions of a world may differ because rounding
 decides whether a contact that is there at the start is found in one step or in the next:
 its bodies are flush to within `rounding` [m]. Until the contact is found, the
 bodies go on approaching, and each body that moves falls by up to 2 a h², a the greatest
 acceleration of a body by its loads. The sum is taken 1.5 times. It is 0 if no contact is
 flush. All of it comes from the world, not from the motion that is judged. [m] */
double LatenessOfFlushContacts(const World& world, double rounding);

}  // namespace touchstone
