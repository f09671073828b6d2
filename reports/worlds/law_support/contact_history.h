#pragma once

#include <vector>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Returns the impulse of gravity and of the constant force on body `index` from sample
 `s` − 1 to sample `s`. [N s] */
Eigen::Vector3d ImpulseOfLoads(const Motion& motion, int index, std::size_t s);

/** Returns the impulses of the steps after sample `from` up to sample `to`, in order. */
std::vector<const ContactImpulse*> ImpulsesBetween(const Motion& motion, std::size_t from,
                                                   std::size_t to);

/** Returns the impulse of `contact` on body `index`; zero if the body is neither A nor B.
 [N s] */
Eigen::Vector3d ImpulseOn(const ContactImpulse& contact, int index);

/** Returns the pushes on body `index` that act in the steps between two times. A push
 acts in the step that starts at its time. */
std::vector<const Push*> PushesBetween(const World& world, int index, double from,
                                       double to);

}  // namespace touchstone
