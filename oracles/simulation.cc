#include "oracles/simulation.h"

#include <cmath>

#include "scenarios/worlds/magnitudes.h"

namespace touchstone {
namespace {

bool IsSane(const Eigen::Vector3d& v) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() < kMostReached;
}

}  // namespace

void Simulation::ReadImpulses(std::vector<ContactImpulse>&) const {}

bool IsSane(const WorldState& state) {
  for (const BodyState& body : state.bodies) {
    if (!IsSane(body.p_WB) || !IsSane(body.v_WB) || !IsSane(body.w_WB) ||
        !body.q_WB.coeffs().allFinite()) {
      return false;
    }
  }
  for (const std::vector<PointState>* points : {&state.particles, &state.nodes}) {
    for (const PointState& point : *points) {
      if (!IsSane(point.p_W) || !IsSane(point.v_W)) return false;
    }
  }
  return true;
}

bool IsSane(const ContactImpulse& contact) {
  // The momentum of the heaviest body at the largest speed, gained and lost.
  constexpr double kLargestImpulse = 2 * kMostMagnitude * kMostReached;
  return IsSane(contact.p_WC) && IsSane(contact.n_AB_W) && contact.J_B_W.allFinite() &&
         contact.J_B_W.cwiseAbs().maxCoeff() < kLargestImpulse;
}

Trajectory RunToEnd(Simulation& simulation, const World& world) {
  Trajectory trajectory;
  trajectory.status = AnswerStatus::kAnswered;
  trajectory.gives_impulses = simulation.GivesImpulses();
  WorldState state;
  simulation.Read(state);
  trajectory.times.push_back(0);
  trajectory.samples.push_back(state);
  for (int step = 1; step <= world.steps; ++step) {
    for (const touchstone::Push& push : world.pushes) {
      // Times are multiples of dt up to rounding, so the nearest step is the right one.
      if (std::lround(push.time / world.dt) != step - 1) continue;
      const BodyState& body = state.bodies[static_cast<std::size_t>(push.body)];
      simulation.Push(push.body, body.p_WB + body.q_WB * push.p_BoP, push.J_W);
    }
    simulation.Step();
    const std::size_t before = trajectory.impulses.size();
    simulation.ReadImpulses(trajectory.impulses);
    bool is_sane = true;
    for (std::size_t i = before; i < trajectory.impulses.size(); ++i) {
      trajectory.impulses[i].step = step;
      is_sane = is_sane && IsSane(trajectory.impulses[i]);
    }
    simulation.Read(state);
    if (!is_sane || !IsSane(state)) {
      trajectory.diverged_at_step = step;
      break;
    }
    if (step % world.sample_every == 0) {
      trajectory.times.push_back(step * world.dt);
      trajectory.samples.push_back(state);
    }
  }
  return trajectory;
}

}  // namespace touchstone
