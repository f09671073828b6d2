#pragma once

#include "scenarios/contact_query.h"

namespace touchstone::referee {

/** Returns how far the signed separation can move when every number of the query moves by
 an ulp and each matrix is replaced by the nearest rotation: the half-width of the band in
 which nobody can be wrong about touching. [m] */
double InputRounding(const ContactQuery& query);

}  // namespace touchstone::referee
