#include "oracles/mujoco/mujoco_oracles.h"

#include <string>
#include <utility>

#include "oracles/answer_each.h"
#include "oracles/isolated_oracle.h"
#include "oracles/mujoco/mujoco_model.h"
#include "oracles/mujoco/mujoco_world.h"

namespace touchstone {
namespace {

class MujocoOracle final : public Oracle {
 public:
  MujocoOracle(std::string name, MujocoIntegrator integrator) : integrator_(integrator) {
    info_.name = std::move(name);
    info_.library = "MuJoCo";
    info_.version = mj_versionString();
    for (auto& row : info_.capabilities) {
      for (Capability& capability : row) capability.reason = "simulates worlds only";
    }
    DescribeMujocoWorlds(integrator, info_);
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    AnswerEach(info_, queries, answers,
               [](const ContactQuery&) { return ContactAnswer(); });
  }

  std::unique_ptr<Simulation> Begin(const World& world) const override {
    return MujocoWorld(world, integrator_, MujocoContacts::kRigid);
  }

  std::unique_ptr<Simulation> BeginAsShipped(const World& world) const override {
    return MujocoWorld(world, integrator_, MujocoContacts::kAsShipped);
  }

 private:
  MujocoIntegrator integrator_;
  OracleInfo info_;
};

}  // namespace

std::vector<std::unique_ptr<Oracle>> MujocoOracles() {
  InitialiseMujoco();
  std::vector<std::unique_ptr<Oracle>> oracles;
  oracles.push_back(std::make_unique<MujocoOracle>("mujoco", MujocoIntegrator::kEuler));
  oracles.push_back(std::make_unique<MujocoOracle>("mujoco/rk4", MujocoIntegrator::kRk4));
  // What it calls an error ends the process.
  for (std::unique_ptr<Oracle>& oracle : oracles)
    oracle = Isolate(std::move(oracle), {}, IsolationScope::kWorlds);
  return oracles;
}

}  // namespace touchstone
