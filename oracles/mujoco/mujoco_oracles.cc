#include "oracles/mujoco/mujoco_oracles.h"

#include <utility>

#include "oracles/isolation/isolated_oracle.h"
#include "oracles/mujoco/mujoco_contacts.h"
#include "oracles/mujoco/mujoco_model.h"
#include "oracles/mujoco/mujoco_world.h"

namespace touchstone {
namespace {

class MujocoOracle final : public Oracle {
 public:
  explicit MujocoOracle(MujocoIntegrator integrator) : integrator_(integrator) {
    info_.library = "MuJoCo";
    info_.version = mj_versionString();
    if (integrator == MujocoIntegrator::kEuler) {
      info_.name = "mujoco";
      DescribeMujocoContacts(info_);
    } else {
      info_.name = "mujoco/rk4";
      for (auto& row : info_.capabilities) {
        for (Capability& capability : row)
          capability.reason =
              "RK4 only steps worlds; the oracle \"mujoco\" answers contact queries";
      }
    }
    DescribeMujocoWorlds(integrator, info_);
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    AnswerByMujoco(info_, queries, answers);
  }

  std::string CannotSimulate(const World& world) const override {
    const std::string reason = Oracle::CannotSimulate(world);
    return reason.empty() ? WhyNoMujocoWorld(world) : reason;
  }

  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return MujocoWorld(world, integrator_, values);
  }

 private:
  MujocoIntegrator integrator_;
  OracleInfo info_;
};

}  // namespace

std::vector<std::unique_ptr<Oracle>> MujocoOracles() {
  InitialiseMujoco();
  std::vector<std::unique_ptr<Oracle>> oracles;
  oracles.push_back(std::make_unique<MujocoOracle>(MujocoIntegrator::kEuler));
  oracles.push_back(std::make_unique<MujocoOracle>(MujocoIntegrator::kRk4));
  // An error inside MuJoCo ends the process.
  for (std::unique_ptr<Oracle>& oracle : oracles)
    oracle = Isolate(std::move(oracle), {}, IsolationScope::kWorlds);
  return oracles;
}

}  // namespace touchstone
