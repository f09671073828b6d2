#include "scenarios/generators/worlds/world_draw.h"

#include <algorithm>
#include <cmath>

#include "scenarios/generators/portable_math.h"

namespace touchstone {
namespace {

/** The number of samples beyond which several steps lie between two of them: enough to
 see every phase of a motion, and few enough that judging takes no longer than stepping.
 */
constexpr int kMostSamples = 120;

/** Least distance between the bounding spheres of two bodies at the start. [m] */
constexpr double kGap = 0.02;

}  // namespace

double WorldDraw::Coefficient() {
  const int kind = random.Below(5);
  const double between = random.Uniform();
  if (kind > 1) return between;
  return kind;
}

Eigen::Vector3d WorldDraw::HalfExtents() {
  const double x = random.Uniform(0.05, 0.4);
  const double y = random.Uniform(0.05, 0.4);
  const double z = random.Uniform(0.05, 0.4);
  return {x, y, z};
}

WorldScenario EmptyWorld(const WorldDraw& draw, const std::string& title,
                         double duration) {
  WorldScenario scenario;
  scenario.title = title;
  World& world = scenario.world;
  world.gravity_W = {0, 0, -kGravity};
  world.dt = draw.dt;
  const int steps = std::max(1, static_cast<int>(duration / draw.dt));
  world.sample_every = (steps + kMostSamples - 1) / kMostSamples;
  // A whole number of samples.
  world.steps = steps - steps % world.sample_every;
  return scenario;
}

RigidBody& AddBody(WorldScenario& scenario, const std::string& named, const Shape& shape,
                   double mass, const Pose& X_WB) {
  RigidBody& body = scenario.world.bodies.emplace_back();
  body.name = named;
  body.placed = {shape, X_WB};
  body.mass = mass;
  return body;
}

void AddGround(WorldScenario& scenario, WorldDraw& draw, double reach) {
  const double depth = 1;  // [m]
  if (draw.random.Coin()) {
    AddBody(scenario, "ground", HalfSpace{}, 0, Pose());
  } else {
    AddBody(scenario, "ground", Box{{reach, reach, depth}}, 0,
            Pose::FromMatrix({0, 0, -depth}, Eigen::Matrix3d::Identity()));
  }
}

Eigen::Vector3d FreePlace(const World& world, const Eigen::Vector3d& near_W,
                          double distance, double radius, Random& random) {
  for (;;) {
    Eigen::Vector3d p_W = near_W + distance * random.Direction();
    const bool is_free =
        std::all_of(world.bodies.begin(), world.bodies.end(), [&](const RigidBody& body) {
          const double reach = radius + BoundingRadius(body.placed.shape) + kGap;
          return Norm(body.placed.X_WB.p_WB - p_W) > reach;
        });
    if (is_free) return p_W;
    distance *= 1.25;
  }
}

void SetContacts(WorldScenario& scenario, double restitution, double friction) {
  for (RigidBody& body : scenario.world.bodies) {
    body.restitution = restitution;
    body.friction = friction;
  }
}

void AddClaim(WorldScenario& scenario, const std::string& law,
              const std::vector<std::string>& about, const std::string& because) {
  scenario.claims.push_back(
      {.law = law, .about = about, .numbers = {}, .because = because});
}

Eigen::Quaterniond TurnedAboutZ(Random& random) {
  const Eigen::Vector2d half = random.PlaneDirection();
  return {half.x(), 0, 0, half.y()};
}

void Turn(const Eigen::Quaterniond& q_W, World& world) {
  const Eigen::Matrix3d R_W = q_W.toRotationMatrix();
  for (RigidBody& body : world.bodies) {
    const Pose& X_WB = body.placed.X_WB;
    const Eigen::Quaterniond q_WB = X_WB.q_WB.value_or(Eigen::Quaterniond::Identity());
    body.placed.X_WB = Pose::FromQuaternion(Apply(R_W, X_WB.p_WB), Product(q_W, q_WB));
    body.v_WB = Apply(R_W, body.v_WB);
    body.w_WB = Apply(R_W, body.w_WB);
  }
  for (Particle& particle : world.particles) {
    particle.p_W = Apply(R_W, particle.p_W);
    particle.v_W = Apply(R_W, particle.v_W);
  }
  for (DistanceJoint& joint : world.joints) {
    for (Anchor* anchor : {&joint.A, &joint.B}) {
      if (anchor->on == AnchorKind::kWorld) anchor->point = Apply(R_W, anchor->point);
    }
  }
  world.gravity_W = Apply(R_W, world.gravity_W);
}

}  // namespace touchstone
