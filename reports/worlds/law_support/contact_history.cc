#include "reports/worlds/law_support/contact_history.h"

#include <algorithm>
#include <cmath>

namespace touchstone {

Eigen::Vector3d ImpulseOfLoads(const Motion& motion, int index, std::size_t s) {
  const RigidBody& body = motion.world.bodies[static_cast<std::size_t>(index)];
  const std::vector<double>& times = motion.trajectory.times;
  // Whole steps, since the difference of two times has lost digits.
  const double time =
      motion.world.dt * std::round((times[s] - times[s - 1]) / motion.world.dt);
  return time * (body.mass * motion.world.gravity_W + body.force_W);
}

std::vector<const ContactImpulse*> ImpulsesBetween(const Motion& motion, std::size_t from,
                                                   std::size_t to) {
  const auto step_of = [&](std::size_t sample) {
    return static_cast<int>(
        std::lround(motion.trajectory.times[sample] / motion.world.dt));
  };
  const std::vector<ContactImpulse>& all = motion.trajectory.impulses;
  const auto later = [](int step, const ContactImpulse& contact) {
    return step < contact.step;
  };
  std::vector<const ContactImpulse*> between;
  for (auto it = std::upper_bound(all.begin(), all.end(), step_of(from), later);
       it != all.end() && it->step <= step_of(to); ++it)
    between.push_back(&*it);
  return between;
}

Eigen::Vector3d ImpulseOn(const ContactImpulse& contact, int index) {
  if (contact.B == index) return contact.J_B_W;
  if (contact.A == index) return -contact.J_B_W;
  return Eigen::Vector3d::Zero();
}

std::vector<const Push*> PushesBetween(const World& world, int index, double from,
                                       double to) {
  std::vector<const Push*> between;
  const double grace = world.dt / 2;
  for (const Push& push : world.pushes) {
    if (push.body == index && push.time > from - grace && push.time < to - grace)
      between.push_back(&push);
  }
  return between;
}

}  // namespace touchstone
