#pragma once

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

class JudgedAnswer;

/** Returns o(n) − depth*, as far as it is proved: how much shorter a translation along
 another direction is. [m] o(n) is an upper bound on the depth for every n, with equality
 for the best ones. Normals are thus judged without comparing angles, and a tie between
 two axes is never a false alarm. If the shapes are apart, it is the distance minus the
 gap along n: the part of the distance that n fails to prove. Source: Cameron & Culley,
 ICRA 1986; judging by excess is MuJoCo's
 test/engine/engine_collision_box_fuzz_test.cc:384-386.
 @pre `n_W` is finite and not zero. */
double Excess(const ContactQuery& query, const ContactTruth& truth,
              const Eigen::Vector3d& n_W);

/** The same for a known OverlapAlong() the normal. */
double Excess(const Enclosure& overlap, const ContactTruth& truth);

/** Judges the normal that the answer states. A normal of bodies that are apart, from an
 oracle that promises no distance, need only separate them: its opposite is wrong, and
 any other direction claims nothing that could be verified. */
void CheckNormal(JudgedAnswer& judged);

}  // namespace touchstone
