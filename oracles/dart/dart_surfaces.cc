#include "oracles/dart/dart_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone {

DartSurfaces::DartSurfaces(const World& world) {
  for (const RigidBody& body : world.bodies) {
    if (!body.collides || body.mass == 0) continue;
    if (moving_++ == 0) {
      restitution_ = body.restitution;
      friction_ = body.friction;
    }
    if (body.restitution != restitution_) {
      why_not_ =
          "DART multiplies the restitutions of two bodies: all "
          "moving bodies must have the same";
    }
    if (body.friction != friction_) {
      why_not_ =
          "DART takes the smaller friction of two bodies: all "
          "moving bodies must have the same";
    }
  }
  for (const RigidBody& body : world.bodies) {
    if (body.collides && body.mass == 0 && moving_ > 1 && body.friction > friction_) {
      why_not_ =
          "DART takes the smaller friction of two bodies: static bodies must have no "
          "more than moving ones";
    }
  }
}

double DartSurfaces::RestitutionOf(const RigidBody& body) const {
  if (restitution_ == 0) return 0;
  return std::min(body.restitution, restitution_) / std::sqrt(restitution_);
}

double DartSurfaces::FrictionOf(const RigidBody& body) const {
  if (body.mass == 0) return std::sqrt(friction_ * body.friction);
  return moving_ == 1 ? std::numeric_limits<double>::max() : friction_;
}

}  // namespace touchstone
