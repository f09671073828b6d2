#include "reports/shrink/question.h"

#include "reports/worlds/study/check_claims.h"
#include "scenarios/scenario_file.h"
#include "scenarios/validate_scenario.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

/** Collects addresses of numbers. */
class Numbers {
 public:
  void Add(double& number) { numbers_.push_back(&number); }
  void Add(Eigen::Vector3d& v) {
    for (double& x : v) Add(x);
  }
  void Add(Anchor& anchor) { Add(anchor.point); }
  void Add(ClothSprings& springs) {
    Add(springs.stiffness);
    Add(springs.damping);
  }
  void Add(Body& body) {
    for (double* const size : SizesOf(body.shape)) Add(*size);
    if (auto* const hull = std::get_if<ConvexHull>(&body.shape)) {
      for (Eigen::Vector3d& vertex : hull->vertices) Add(vertex);
    }
    Add(body.X_WB.p_WB);
  }
  void Add(RigidBody& body) {
    Add(body.placed);
    Add(body.mass);
    if (body.inertia) Add(*body.inertia);
    Add(body.v_WB);
    Add(body.w_WB);
    Add(body.restitution);
    Add(body.friction);
    Add(body.force_W);
  }
  void Add(Particle& particle) {
    Add(particle.p_W);
    Add(particle.v_W);
    Add(particle.mass);
    Add(particle.damping);
    Add(particle.bounce);
  }
  void Add(Spring& spring) {
    Add(spring.A);
    Add(spring.B);
    Add(spring.stiffness);
    Add(spring.damping);
    Add(spring.rest_length);
  }
  void Add(DistanceJoint& joint) {
    Add(joint.A);
    Add(joint.B);
    Add(joint.length);
  }
  void Add(Cloth& cloth) {
    Add(cloth.spacing);
    Add(cloth.centre);
    Add(cloth.node_mass);
    Add(cloth.damping);
    Add(cloth.bounce);
    Add(cloth.structural);
    Add(cloth.shear);
    Add(cloth.bend);
  }
  void Add(Push& push) {
    Add(push.time);
    Add(push.p_BoP);
    Add(push.J_W);
  }
  template <typename Part>
  void Add(std::vector<Part>& parts) {
    for (Part& part : parts) Add(part);
  }
  void Add(Scenario& scenario) {
    Add(scenario.contact.A);
    Add(scenario.contact.B);
  }
  void Add(WorldScenario& scenario) {
    World& world = scenario.world;
    Add(world.bodies);
    Add(world.particles);
    Add(world.springs);
    Add(world.joints);
    Add(world.cloths);
    Add(world.pushes);
    Add(world.gravity_W);
    Add(world.dt);
  }

  std::vector<double*> operator()() && { return std::move(numbers_); }

 private:
  std::vector<double*> numbers_;
};

}  // namespace

const std::string& IdOf(const Question& question) {
  return std::visit(
      [](const auto& scenario) -> const std::string& { return scenario.id; }, question);
}

std::vector<Body*> BodiesOf(Question& question) {
  if (auto* const scenario = std::get_if<Scenario>(&question))
    return {&scenario->contact.A, &scenario->contact.B};
  std::vector<Body*> bodies;
  for (RigidBody& body : std::get<WorldScenario>(question).world.bodies)
    bodies.push_back(&body.placed);
  return bodies;
}

std::vector<const Body*> BodiesOf(const Question& question) {
  if (const auto* const scenario = std::get_if<Scenario>(&question))
    return {&scenario->contact.A, &scenario->contact.B};
  std::vector<const Body*> bodies;
  for (const RigidBody& body : std::get<WorldScenario>(question).world.bodies)
    bodies.push_back(&body.placed);
  return bodies;
}

std::vector<double*> SizesOf(Shape& shape) {
  if (auto* const s = std::get_if<Sphere>(&shape)) return {&s->radius};
  if (auto* const s = std::get_if<Box>(&shape))
    return {&s->half_extents[0], &s->half_extents[1], &s->half_extents[2]};
  if (auto* const s = std::get_if<Capsule>(&shape)) return {&s->radius, &s->half_length};
  if (auto* const s = std::get_if<Cylinder>(&shape)) return {&s->radius, &s->half_length};
  if (auto* const s = std::get_if<Cone>(&shape)) return {&s->radius, &s->half_height};
  return {};
}

std::vector<double*> NumbersOf(Question& question) {
  Numbers numbers;
  std::visit([&](auto& scenario) { numbers.Add(scenario); }, question);
  return std::move(numbers)();
}

bool IsValid(const Question& question) {
  if (const auto* const scenario = std::get_if<Scenario>(&question))
    return FaultsOf(*scenario).empty();
  const auto& world = std::get<WorldScenario>(question);
  return FaultsOf(world).empty() && ErrorsOfClaims(world).empty();
}

std::string TextOf(const Question& question) {
  return std::visit([](const auto& scenario) { return WriteScenario(scenario); },
                    question);
}

}  // namespace touchstone
