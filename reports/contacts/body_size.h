#pragma once

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the smallest feature of the two bodies: a radius, half of a side or of a
 height, or half of the least extent of a hull along the axes of its body. Half-spaces
 have none. [m] */
double SmallestFeature(const ContactQuery& query);

/** Returns the greatest extent of the smaller body: the diameter of the ball about its
 origin that holds it, or of the box that holds a hull. [m] */
double SmallerExtent(const ContactQuery& query);

/** Returns the sum of the greatest extents of both bodies, without half-spaces. [m] */
double SumOfExtents(const ContactQuery& query);

}  // namespace touchstone
