#include "oracles/bullet/bullet_oracles.h"

#include <stdexcept>
#include <utility>

#include <dlfcn.h>

#include "oracles/bullet/bullet_module.h"
#include "oracles/bullet/bullet_oracle_info.h"
#include "oracles/bullet/bullet_simulation.h"
#include "oracles/bullet/engine_module.h"
#include "oracles/no_answer.h"

namespace touchstone {
namespace {

/** A prepared batch whose shapes and poses are owned by the module. */
class BulletBatch : public PreparedBatch {
 public:
  BulletBatch(const BulletModule& module, BulletPath path,
              std::span<const ContactQuery> queries)
      : module_(module),
        separations_(queries.size()),
        batch_(module.prepare(path, queries.data(), queries.size())) {}
  ~BulletBatch() override { module_.discard(batch_); }
  BulletBatch(const BulletBatch&) = delete;
  BulletBatch& operator=(const BulletBatch&) = delete;

  void Run() override { module_.run(batch_, separations_.data()); }
  std::span<const double> separations() const override { return separations_; }

 private:
  const BulletModule& module_;
  std::vector<double> separations_;
  void* batch_;
};

class BulletOracle : public Oracle {
 public:
  BulletOracle(BulletPrecision precision, BulletPath path, const BulletModule& module)
      : info_(BulletOracleInfo(precision, path, module)), path_(path), module_(module) {}

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    std::vector<const ContactQuery*> supported;
    std::vector<ContactAnswer*> slots;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Capability& capability =
          info_.For(KindOf(queries[i].A.shape), KindOf(queries[i].B.shape));
      if (capability.supported) {
        supported.push_back(&queries[i]);
        slots.push_back(&answers[i]);
      } else {
        answers[i] = UnsupportedAnswer(capability.reason);
      }
    }
    module_.answer(path_, supported.data(), slots.data(), supported.size());
  }

  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return std::make_unique<BulletBatch>(module_, path_, queries);
  }

  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return info_.simulates ? BulletSimulation(module_, world, values) : nullptr;
  }

 private:
  OracleInfo info_;
  BulletPath path_;
  const BulletModule& module_;
};

/* Whether program and module agree on the sizes of the types they exchange. */
bool Fits(const BulletModule& module) {
  return module.query_size == sizeof(ContactQuery) &&
         module.answer_size == sizeof(ContactAnswer) &&
         module.world_size == sizeof(World) && module.state_size == sizeof(BodyState) &&
         module.impulse_size == sizeof(ContactImpulse);
}

const BulletModule& OpenBullet(BulletPrecision precision) {
  const std::string name = precision == BulletPrecision::kDouble
                               ? "touchstone_bullet_double"
                               : "touchstone_bullet_float";
  using Entry = const BulletModule*();
  auto* entry =
      reinterpret_cast<Entry*>(dlsym(OpenEngineModule(name), kBulletModuleSymbol));
  if (entry == nullptr || !Fits(*entry())) {
    throw std::runtime_error(name + ".so belongs to another build of Touchstone");
  }
  return *entry();
}

}  // namespace

std::vector<std::unique_ptr<Oracle>> BulletOracles(BulletPrecision precision) {
  const BulletModule& module = OpenBullet(precision);
  std::vector<std::unique_ptr<Oracle>> oracles;
  for (const BulletPath path : {BulletPath::kWorldDispatch, BulletPath::kClosestPoints}) {
    oracles.push_back(std::make_unique<BulletOracle>(precision, path, module));
  }
  return oracles;
}

}  // namespace touchstone
