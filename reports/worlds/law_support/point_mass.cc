#include "reports/worlds/law_support/point_mass.h"

#include <algorithm>

#include "reports/worlds/truth/mechanics.h"

namespace touchstone {

PointState PointMass::In(const WorldState& state) const {
  const auto i = static_cast<std::size_t>(index);
  if (on == AnchorKind::kParticle) return state.particles[i];
  return {state.bodies[i].p_WB, state.bodies[i].v_WB};
}

std::function<BodyState(const WorldState&)> PointMass::Reader() const {
  return [*this](const WorldState& state) {
    const PointState is = In(state);
    return BodyState{is.p_W, Eigen::Quaterniond::Identity(), is.v_W,
                     Eigen::Vector3d::Zero()};
  };
}

bool PointMass::IsAt(const Anchor& anchor) const {
  return anchor.on == on && anchor.index == index && anchor.point.isZero(0);
}

std::vector<PointMass> PointMassesOf(const World& world, const Subjects& subjects) {
  std::vector<PointMass> points;
  for (const int i : subjects.bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    points.push_back({AnchorKind::kBody,
                      i,
                      body.name,
                      body.mass,
                      0,
                      {body.placed.X_WB.p_WB, body.v_WB},
                      AccelerationOf(world, body)});
  }
  for (const int i : subjects.particles) {
    const Particle& particle = world.particles[static_cast<std::size_t>(i)];
    points.push_back({AnchorKind::kParticle,
                      i,
                      particle.name,
                      particle.mass,
                      particle.damping,
                      {particle.p_W, particle.v_W},
                      world.gravity_W});
  }
  return points;
}

std::vector<PointMass> PointMassesInOrder(const World& world, const Claim& claim) {
  std::vector<PointMass> points = PointMassesOf(world, SubjectsOf(world, claim));
  const auto place = [&](const PointMass& point) {
    return std::find(claim.about.begin(), claim.about.end(), point.name);
  };
  std::stable_sort(
      points.begin(), points.end(),
      [&](const PointMass& a, const PointMass& b) { return place(a) < place(b); });
  return points;
}

std::optional<Eigen::Vector3d> FixedPointOf(const World& world, const Anchor& anchor) {
  if (Moves(world, anchor)) return std::nullopt;
  return StartOf(world, anchor);
}

}  // namespace touchstone
