#include "oracles/dart/dart_oracles.h"

#include <utility>

#include <dart/config.hpp>

#include "oracles/answer_each.h"
#include "oracles/dart/dart_contacts.h"
#include "oracles/dart/dart_surfaces.h"
#include "oracles/dart/dart_world.h"
#include "oracles/isolation/isolated_oracle.h"

namespace touchstone {
namespace {

class DartOracle final : public Oracle {
 public:
  DartOracle() {
    info_.name = "dart";
    info_.library = "DART";
    info_.version = DART_VERSION;
    DescribeDartContacts(info_);
    DescribeDartWorlds(info_);
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    AnswerEach(info_, queries, answers, AnswerByDart);
  }

  std::string CannotSimulate(const World& world) const override {
    const std::string reason = Oracle::CannotSimulate(world);
    return reason.empty() ? DartSurfaces(world).why_not() : reason;
  }

  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return DartWorld(world, values);
  }

 private:
  OracleInfo info_;
};

}  // namespace

std::vector<std::unique_ptr<Oracle>> DartOracles() {
  std::vector<std::unique_ptr<Oracle>> oracles;
  // DART's assertions are enabled, and a failed one ends the process.
  oracles.push_back(Isolate(std::make_unique<DartOracle>(), {}, IsolationScope::kWorlds));
  return oracles;
}

}  // namespace touchstone
