#pragma once

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the overlap along `n_W`, evaluated with a 64-bit significand by independent
 formulas. [m] */
double OverlapFound(const ContactQuery& query, const Eigen::Vector3d& n_W);

/** Returns the least overlap found along some thousand directions and around the best of
 them, evaluated with a 64-bit significand by independent formulas. It is an upper bound
 on minus the separation of any pair of bounded shapes, and a tight one if the search is
 lucky. [m] */
double LeastOverlapFound(const ContactQuery& query);

}  // namespace touchstone
