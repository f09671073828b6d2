#pragma once

#include <vector>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/subjects.h"

namespace touchstone {

/** Returns σ² of a body: the largest m (r × n)ᵀ I⁻¹ (r × n) over its points r, measured
 from the centre, and unit vectors n. So 1 + σ² is the largest ratio of the responses of
 its points and of its centre to an impulse. 0 for a sphere, whose contacts lie along the
 normal, and for a static body; 4.5 for a cube, 6 for a thin rod or plate. [-] */
double Eccentricity(const RigidBody& body);

/** Returns the most energy that an impact with Newton's restitution `restitution` and
 Coulomb's friction gains, over the kinetic energy of the approach: e² (1 + σ²) − 1, or 0.
 `eccentricity`: the larger σ² of the two bodies. [-]

 Newton's rule u_n' = −e u_n counts what friction gives to the normal velocity as a part
 of the approach (Kane & Levinson, Dynamics: Theory and Applications, 1985, §5.8). Let p
 and q be the changes of the velocities by the normal and the tangential impulses J and F,
 in the metric of the kinetic energy: p² is pᵀMp. The rule says p² + p·q = (1+e) W with W
 = −p·v = Σ J |u_n|. Friction opposes the slip that it leaves, so the energy rises by at
 most −½ (1−e) W − ½ (p·q + q²). With κ the squared cosine between p and q,
 q² >= (p·q)²/(κ p²), and the largest value over p·q is (e²/(1−κ) − 1) W²/2p². W²/2p² is
 the kinetic energy of the part of v along p, at most ½ m u² for the reduced mass m and
 the largest |u_n| of the contacts, u. Contacts of one pair have one normal n and a
 centre of pressure r. Then p² is J² (1/m)(1 + y²) with y² <= σ², and p differs from every
 q by at least the translation along n, J²/m. So κ <= σ²/(1+σ²), of two bodies that of the
 larger σ². Impacts of several pairs at once are not covered. */
double MostImpactGain(double restitution, double eccentricity);

/** Returns the most energy that impacts may have added to the subjects from the start to
 each sample, by MostImpactGain() of each pair with friction that may meet in a step. The
 approach has at most the energy ½ m u² of the speed at which the surfaces close along
 the normal of their gap, with the loads of the step; between samples of several steps,
 the kinetic energy of the two relative to their common centre. [J] */
std::vector<double> ImpactEnergyGain(const Motion& motion, const AllowedMotion& allowed,
                                     const Subjects& subjects);

}  // namespace touchstone
