#include "tests/reports/bench/planted_simulator.h"

#include <utility>

#include "tests/reports/worlds/motions.h"

namespace touchstone {
namespace {

class Planted final : public Simulation {
 public:
  Planted(const World& world, int threads, PlantedSimulator::Deed deed)
      : world_(world), threads_(threads), deed_(std::move(deed)) {}

  void Push(int, const Eigen::Vector3d&, const Eigen::Vector3d&) override {}
  void Step() override {
    ++step_;
    if (deed_) deed_(threads_, step_);
  }
  void Read(WorldState& state) const override {
    state = {};
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    for (const RigidBody& body : world_.bodies) {
      state.bodies.push_back({body.placed.X_WB.p_WB + step_ * x,
                              Eigen::Quaterniond::Identity(), 3 * x,
                              Eigen::Vector3d::Zero()});
    }
  }

 private:
  const World& world_;
  int threads_;
  PlantedSimulator::Deed deed_;
  int step_ = 0;
};

}  // namespace

PlantedSimulator::PlantedSimulator(std::string name, Deed deed) : deed_(std::move(deed)) {
  info_.name = std::move(name);
  info_.simulates = true;
  info_.world_capabilities.fill({true, ""});
}

void PlantedSimulator::Answer(std::span<const ContactQuery>,
                              std::span<ContactAnswer> answers) const {
  for (ContactAnswer& answer : answers) answer.status = AnswerStatus::kUnsupported;
}

std::unique_ptr<Simulation> PlantedSimulator::Begin(const World& world) const {
  return std::make_unique<Planted>(world, 1, deed_);
}

std::unique_ptr<Simulation> PlantedSimulator::BeginInThreads(const World& world,
                                                             int threads) const {
  return std::make_unique<Planted>(world, threads, deed_);
}

World TwoBalls() {
  World world;
  world.bodies = {BodyOf("static", Sphere{1}, 0, {0, 0, 0}),
                  BodyOf("free", Sphere{1}, 1, {0, 1.75, 0})};
  return world;
}

}  // namespace touchstone
