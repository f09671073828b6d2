#include "reports/worlds/study/motion_drifts.h"

#include <algorithm>

#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {

MotionDrifts DriftsOf(const World& world, const Trajectory& trajectory) {
  const Subjects subjects = SubjectsOf(world, {});
  const WorldState start = StateAtStart(world);
  Eigen::Vector3d force_W = MassOf(world, subjects) * world.gravity_W;
  for (const int i : subjects.bodies)
    force_W += world.bodies[static_cast<std::size_t>(i)].force_W;
  const Eigen::Vector3d P_0 = MomentumOf(world, start, subjects);
  const Eigen::Vector3d L_0 =
      AngularMomentumOf(world, start, subjects, CentreOf(world, start, subjects));
  const double E_0 = EnergyOf(world, start, subjects).total();
  double least = E_0;
  MotionDrifts drifts;
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
    const WorldState& state = trajectory.samples[s];
    const double t = trajectory.times[s];
    const double E = EnergyOf(world, state, subjects).total();
    drifts.energy_gained = std::max(drifts.energy_gained, E - least);
    drifts.energy_lost = std::max(drifts.energy_lost, E_0 - E);
    least = std::min(least, E);
    Eigen::Vector3d given_W = force_W * t;
    for (const Push& push : world.pushes)
      if (t > push.time + world.dt / 2) given_W += push.J_W;
    drifts.momentum = std::max(
        drifts.momentum, (MomentumOf(world, state, subjects) - P_0 - given_W).norm());
    const Eigen::Vector3d L =
        AngularMomentumOf(world, state, subjects, CentreOf(world, state, subjects));
    drifts.angular_momentum = std::max(drifts.angular_momentum, (L - L_0).norm());
  }
  return drifts;
}

}  // namespace touchstone
