#include "oracles/bullet/bullet_simulation.h"

namespace touchstone {
namespace {

std::vector<Eigen::Vector3d> InertiasOf(const World& world) {
  std::vector<Eigen::Vector3d> inertias;
  for (const RigidBody& body : world.bodies) inertias.push_back(InertiaOf(body));
  return inertias;
}

/** A simulation whose world is owned by the module. */
class ModuleSimulation final : public Simulation {
 public:
  ModuleSimulation(const BulletModule& module, const World& world,
                   std::span<const double> values)
      : module_(module),
        world_(module.begin(world, InertiasOf(world), {values.begin(), values.end()})) {}
  ~ModuleSimulation() override { module_.end(world_); }
  ModuleSimulation(const ModuleSimulation&) = delete;
  ModuleSimulation& operator=(const ModuleSimulation&) = delete;

  void Push(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W) override {
    module_.push(world_, body, p_W, J_W);
  }
  void Step() override { module_.step(world_); }
  void Read(WorldState& state) const override { module_.read(world_, state); }
  void ReadImpulses(std::vector<ContactImpulse>& impulses) const override {
    module_.read_impulses(world_, impulses);
  }
  bool GivesImpulses() const override { return true; }

 private:
  const BulletModule& module_;
  BulletWorld* world_;
};

}  // namespace

std::unique_ptr<Simulation> BulletSimulation(const BulletModule& module,
                                             const World& world,
                                             std::span<const double> values) {
  return std::make_unique<ModuleSimulation>(module, world, values);
}

}  // namespace touchstone
