#include "engine/dynamics/world/world.h"

#include "engine/dynamics/world/world_impl.h"

namespace cookbook {

World::World(const Settings& settings) : impl_(std::make_unique<Impl>(settings)) {}

World::~World() = default;

int World::AddBody(const BodyDefinition& definition) {
  return impl_->AddBody(definition);
}

int World::AddJoint(const DistanceJoint& joint) {
  return impl_->AddJoint(joint);
}

int World::AddSpring(const Spring& spring) {
  return impl_->AddSpring(spring);
}

void World::ApplyImpulse(int body, const Eigen::Vector3d& p_W,
                         const Eigen::Vector3d& J_W) {
  impl_->ApplyImpulse(body, p_W, J_W);
}

void World::ApplyForce(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& F_W) {
  impl_->ApplyForce(body, p_W, F_W);
}

void World::Step(double dt) {
  impl_->Step(dt);
}

int World::body_count() const {
  return impl_->body_count();
}

const BodyState& World::state(int body) const {
  return impl_->state(body);
}

const Settings& World::settings() const {
  return impl_->settings();
}

bool World::IsAsleep(int body) const {
  return impl_->IsAsleep(body);
}

void World::AppendContactImpulses(std::vector<ContactImpulse>& impulses) const {
  impl_->AppendContactImpulses(impulses);
}

bool World::diverged() const {
  return impl_->diverged();
}

}  // namespace cookbook
