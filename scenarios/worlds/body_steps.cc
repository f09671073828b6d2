#include "scenarios/worlds/body_steps.h"

namespace touchstone {

double BodySteps(const World& world) {
  double things = static_cast<double>(world.particles.size());
  for (const RigidBody& body : world.bodies) things += body.mass > 0 ? 1 : 0;
  for (const Cloth& cloth : world.cloths)
    things += static_cast<double>(cloth.n) * cloth.n;
  return things * world.steps;
}

}  // namespace touchstone
