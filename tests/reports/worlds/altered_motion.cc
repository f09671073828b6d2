#include "tests/reports/worlds/altered_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reports/worlds/study/motion_scale.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

Vector3d Direction(RandomScene& random) {
  return random.Rotation() * Vector3d::UnitX();
}

/** Returns a moving body at random; empty if there is none. */
std::optional<std::size_t> SomeBody(const World& world, RandomScene& random) {
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (world.bodies[i].mass > 0) moving.push_back(i);
  if (moving.empty()) return std::nullopt;
  return moving[static_cast<std::size_t>(
      random.Uniform(0, static_cast<double>(moving.size())))];
}

/** Returns a sample at random, neither the first nor the last. */
std::size_t SomeSample(const Trajectory& motion, RandomScene& random) {
  const auto samples = static_cast<double>(motion.samples.size());
  return static_cast<std::size_t>(random.Uniform(1, std::max(2.0, samples - 1)));
}

/** Returns the motion with `change(state of a body, steps since)` applied to a body from
 a moment on. */
template <typename Change>
std::optional<Trajectory> WithOneBody(const RightMotion& right, RandomScene& random,
                                      Change&& change) {
  const auto body = SomeBody(right.world, random);
  if (!body || right.trajectory.samples.size() < 3) return std::nullopt;
  Trajectory altered = right.trajectory;
  const std::size_t from = SomeSample(altered, random);
  for (std::size_t s = from; s < altered.samples.size(); ++s)
    change(altered.samples[s].bodies[*body], s - from,
           right.trajectory.samples[from - 1].bodies[*body]);
  return altered;
}

Eigen::Quaterniond TurnedBy(const Eigen::Quaterniond& q_WB, double angle,
                            const Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) * q_WB;
}

std::optional<Trajectory> Jumps(const RightMotion& right, double size,
                                RandomScene& random) {
  const Vector3d way =
      size * ScaleOf(right.world, right.trajectory.samples).length * Direction(random);
  return WithOneBody(right, random, [&](BodyState& body, std::size_t, const BodyState&) {
    body.p_WB += way;
  });
}

std::optional<Trajectory> JumpsForAStep(const RightMotion& right, double size,
                                        RandomScene& random) {
  const Vector3d way =
      size * ScaleOf(right.world, right.trajectory.samples).length * Direction(random);
  return WithOneBody(right, random,
                     [&](BodyState& body, std::size_t since, const BodyState&) {
                       if (since == 0) body.p_WB += way;
                     });
}

std::optional<Trajectory> Stays(const RightMotion& right, double size,
                                RandomScene& random) {
  return WithOneBody(right, random,
                     [&](BodyState& body, std::size_t, const BodyState& before) {
                       body.p_WB += std::min(1.0, size) * (before.p_WB - body.p_WB);
                     });
}

std::optional<Trajectory> TurnsTooLittle(const RightMotion& right, double size,
                                         RandomScene& random) {
  return WithOneBody(right, random,
                     [&](BodyState& body, std::size_t, const BodyState& before) {
                       body.q_WB = body.q_WB.slerp(std::min(1.0, size), before.q_WB);
                     });
}

std::optional<Trajectory> IsTurned(const RightMotion& right, double size,
                                   RandomScene& random) {
  const Vector3d axis = Direction(random);
  return WithOneBody(right, random, [&](BodyState& body, std::size_t, const BodyState&) {
    body.q_WB = TurnedBy(body.q_WB, size, axis);
  });
}

std::optional<Trajectory> StatesAnotherVelocity(const RightMotion& right, double size,
                                                RandomScene& random) {
  return WithOneBody(right, random, [&](BodyState& body, std::size_t, const BodyState&) {
    body.v_WB *= 1 + size;
  });
}

std::optional<Trajectory> StatesAnotherSpin(const RightMotion& right, double size,
                                            RandomScene& random) {
  return WithOneBody(right, random, [&](BodyState& body, std::size_t, const BodyState&) {
    body.w_WB *= 1 + size;
  });
}

/** The body gets a velocity from nowhere, and moves at it. */
std::optional<Trajectory> IsPushedByNobody(const RightMotion& right, double size,
                                           RandomScene& random) {
  const Vector3d v_W =
      size * ScaleOf(right.world, right.trajectory.samples).speed * Direction(random);
  return WithOneBody(right, random,
                     [&](BodyState& body, std::size_t since, const BodyState&) {
                       body.v_WB += v_W;
                       body.p_WB += right.world.dt * static_cast<double>(since + 1) * v_W;
                     });
}

std::optional<Trajectory> IsLate(const RightMotion& right, double, RandomScene&) {
  Trajectory altered = right.trajectory;
  for (std::size_t s = altered.samples.size() - 1; s > 0; --s)
    altered.samples[s] = right.trajectory.samples[s - 1];
  for (ContactImpulse& contact : altered.impulses) ++contact.step;
  std::erase_if(altered.impulses, [&](const ContactImpulse& contact) {
    return contact.step > right.world.steps;
  });
  return altered;
}

/** Returns the motion that the engine gives to a world that `change` has changed; the
 start is that of the world itself. Empty if nothing was changed. */
template <typename Change>
std::optional<Trajectory> InAnotherWorld(const RightMotion& right, Change&& change) {
  World other = right.world;
  if (!change(other)) return std::nullopt;
  Trajectory altered = right.oracle.Simulate(other);
  if (altered.status != AnswerStatus::kAnswered) return std::nullopt;
  altered.times = right.trajectory.times;
  altered.times.resize(altered.samples.size());
  return altered;
}

std::optional<Trajectory> HasAnotherGravity(const RightMotion& right, double size,
                                            RandomScene&) {
  return InAnotherWorld(right, [&](World& world) {
    world.gravity_W *= 1 + size;
    return !world.gravity_W.isZero(0);
  });
}

std::optional<Trajectory> TakesOtherSteps(const RightMotion& right, double size,
                                          RandomScene&) {
  return InAnotherWorld(right, [&](World& world) {
    if (!world.pushes.empty()) return false;
    world.dt *= 1 + size;
    return true;
  });
}

std::optional<Trajectory> HasAnotherRestitution(const RightMotion& right, double size,
                                                RandomScene&) {
  return InAnotherWorld(right, [&](World& world) {
    bool changed = false;
    for (RigidBody& body : world.bodies) {
      const double before = body.restitution;
      body.restitution = before > 0.5 ? before / (1 + size) : before * (1 + size);
      body.restitution = std::min(1.0, body.restitution);
      changed = changed || body.restitution != before;
    }
    return changed;
  });
}

std::optional<Trajectory> HasAnotherFriction(const RightMotion& right, double size,
                                             RandomScene&) {
  return InAnotherWorld(right, [&](World& world) {
    bool changed = false;
    for (RigidBody& body : world.bodies) {
      changed = changed || body.friction > 0;
      body.friction *= 1 + size;
    }
    return changed;
  });
}

std::optional<Trajectory> HasAnotherSize(const RightMotion& right, double size,
                                         RandomScene& random) {
  const auto index = SomeBody(right.world, random);
  if (!index) return std::nullopt;
  return InAnotherWorld(right, [&](World& world) {
    RigidBody& body = world.bodies[*index];
    if (auto* sphere = std::get_if<Sphere>(&body.placed.shape))
      sphere->radius *= 1 + size;
    else if (auto* box = std::get_if<Box>(&body.placed.shape))
      box->half_extents *= 1 + size;
    else
      return false;
    return true;
  });
}

/** Returns the motion with other impulses; empty if the engine reports none. */
template <typename Change>
std::optional<Trajectory> WithImpulses(const RightMotion& right, Change&& change) {
  if (right.trajectory.impulses.empty()) return std::nullopt;
  Trajectory altered = right.trajectory;
  for (ContactImpulse& contact : altered.impulses) change(contact);
  return altered;
}

std::optional<Trajectory> TiltsNormals(const RightMotion& right, double size,
                                       RandomScene& random) {
  const Vector3d towards = Direction(random);
  return WithImpulses(right, [&](ContactImpulse& contact) {
    const Vector3d across = contact.n_AB_W.cross(towards).normalized();
    contact.n_AB_W = Eigen::AngleAxisd(size, across) * contact.n_AB_W;
  });
}

std::optional<Trajectory> ShiftsPoints(const RightMotion& right, double size,
                                       RandomScene& random) {
  const Vector3d way =
      size * ScaleOf(right.world, right.trajectory.samples).length * Direction(random);
  return WithImpulses(right, [&](ContactImpulse& contact) { contact.p_WC += way; });
}

std::optional<Trajectory> ScalesImpulses(const RightMotion& right, double size,
                                         RandomScene&) {
  return WithImpulses(right, [&](ContactImpulse& contact) { contact.J_B_W *= 1 + size; });
}

constexpr std::array kAlterations = {
    MotionAlteration{"jumps", true, Jumps},
    MotionAlteration{"jumps for a step", true, JumpsForAStep},
    MotionAlteration{"stays behind its velocity", false, Stays},
    MotionAlteration{"is turned at once", true, IsTurned},
    MotionAlteration{"turns less than its spin", false, TurnsTooLittle},
    MotionAlteration{"states another velocity", false, StatesAnotherVelocity},
    MotionAlteration{"states another spin", false, StatesAnotherSpin},
    MotionAlteration{"is pushed by nobody", false, IsPushedByNobody},
    MotionAlteration{"is a step late", false, IsLate},
    MotionAlteration{"another gravity", false, HasAnotherGravity},
    MotionAlteration{"another step", false, TakesOtherSteps},
    MotionAlteration{"another restitution", false, HasAnotherRestitution},
    MotionAlteration{"another friction", false, HasAnotherFriction},
    MotionAlteration{"another size of a body", false, HasAnotherSize},
    MotionAlteration{"tilted normals", false, TiltsNormals},
    MotionAlteration{"shifted contacts", false, ShiftsPoints},
    MotionAlteration{"other impulses", false, ScalesImpulses},
};

}  // namespace

std::span<const MotionAlteration> MotionAlterations() {
  return kAlterations;
}

double DeviationBetween(const World& world, const Trajectory& right,
                        const Trajectory& altered) {
  const MotionScale scale = ScaleOf(world, right.samples);
  const double size = scale.length;
  const double speed = scale.speed;
  double deviation = 0;
  const auto take = [&](double difference, double whole) {
    if (difference > 0) deviation = std::max(deviation, difference / whole);
  };
  const std::size_t samples = std::min(right.samples.size(), altered.samples.size());
  for (std::size_t s = 0; s < samples; ++s) {
    const WorldState& a = right.samples[s];
    const WorldState& b = altered.samples[s];
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
      take((a.bodies[i].p_WB - b.bodies[i].p_WB).norm(), size);
      take((a.bodies[i].v_WB - b.bodies[i].v_WB).norm(), speed);
      take((a.bodies[i].w_WB - b.bodies[i].w_WB).norm(), speed / size);
      take(a.bodies[i].q_WB.angularDistance(b.bodies[i].q_WB), 1);
    }
    for (std::size_t i = 0; i < a.particles.size(); ++i) {
      take((a.particles[i].p_W - b.particles[i].p_W).norm(), size);
      take((a.particles[i].v_W - b.particles[i].v_W).norm(), speed);
    }
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
      take((a.nodes[i].p_W - b.nodes[i].p_W).norm(), size);
      take((a.nodes[i].v_W - b.nodes[i].v_W).norm(), speed);
    }
  }
  if (deviation > 0 || right.impulses.size() != altered.impulses.size()) return deviation;
  double largest = 0;
  for (const ContactImpulse& contact : right.impulses)
    largest = std::max(largest, contact.J_B_W.norm());
  for (std::size_t i = 0; i < right.impulses.size(); ++i) {
    const ContactImpulse& a = right.impulses[i];
    const ContactImpulse& b = altered.impulses[i];
    take((a.J_B_W - b.J_B_W).norm(), largest);
    take((a.p_WC - b.p_WC).norm(), size);
    take((a.n_AB_W - b.n_AB_W).norm(), 1);
  }
  return deviation;
}

}  // namespace touchstone
