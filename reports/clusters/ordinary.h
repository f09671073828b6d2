#pragma once

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Returns how ordinary a question is, from 1, what every engine is used for, towards 0:
 1 / (1 + d), with d the sum of the decades by which it is beyond

 - an extent E of the smaller body from 1 cm to 10 m;
 - a body 10 times as long as it is thick;
 - a scene of 100 E, its largest coordinate included;
 - a separation or a depth of E / 1000, at most one decade: nearer to touching, an answer
 may turn on the last digits of its input, but every body at rest touches another.

 @pre At most one of the bodies is a half-space. [-] */
double OrdinaryOf(const ContactQuery& query, const ContactTruth& truth);

/** The same for a world, with E the greatest extent of its smallest moving body:

 - an extent E from 1 cm to 10 m;
 - masses 100 times each other;
 - a largest coordinate of 1000 E at the start;
 - a step of 1/30 s;
 - a starting speed of E in a step.

 A world without moving bodies has only masses and steps. [-] */
double OrdinaryOf(const World& world);

}  // namespace touchstone
