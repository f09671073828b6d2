#pragma once

#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** Returns the largest change of the signed separation when every number of the query
 changes by an ulp and each matrix is replaced by the nearest rotation. It is the
 half-width of the band in which no answer about touching can be proved wrong. [m] */
double InputRounding(const ContactQuery& query);

}  // namespace touchstone::referee
