#pragma once

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns the overlap along `n_W`, evaluated with 64 bits by formulas of its own. [m] */
double OverlapFound(const ContactQuery& query, const Eigen::Vector3d& n_W);

/** Returns the least overlap found along some thousand directions and around the best of
 them, evaluated with 64 bits by formulas of its own: an upper bound on minus the
 separation of any pair of bounded shapes, near it where the search is lucky. [m] */
double LeastOverlapFound(const ContactQuery& query);

}  // namespace touchstone
