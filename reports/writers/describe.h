#pragma once

#include <string>
#include <string_view>

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns "apart", "touching" or "undecided". */
std::string_view NameOf(Touching touching);

/** Returns the shape, sizes and pose: "box, half extents (1, 2, 3) m at (1.2, 0, 0),
 turned by the quaternion (w, x, y, z) = (…)", or by a matrix if the pose was given by
 one. The rotation is left out if it is the identity. */
std::string Describe(const Body& body);

/** Returns the truth and its certificate as a sentence. A scene whose numbers need no
 rounding is decided even where the bodies are flush, see contacts/exact_scene.h. */
std::string Describe(const ContactQuery& query, const ContactTruth& truth);

/** Returns the distance of `separation` from the enclosure of the truth: a lower bound of
 its error. NaN for NaN. [m] */
double LeastError(double separation, const ContactTruth& truth);

}  // namespace touchstone
