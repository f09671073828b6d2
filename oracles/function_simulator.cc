#include "oracles/function_simulator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace touchstone {
namespace {

void SetSlop(const SimulatorPromises& promises, OracleInfo& info) {
  if (!std::isfinite(promises.slop) || promises.slop < 0) {
    throw std::invalid_argument(
        fmt::format("the slop of {} is {} m; expected a finite depth >= 0", info.name,
                    promises.slop));
  }
  if (promises.slop == 0) return;
  if (promises.documented_by.empty()) {
    throw std::invalid_argument(fmt::format(
        "the slop of {}, {} m, is documented nowhere; expected its source, e.g. "
        ".documented_by = \"its manual, section 4\"",
        info.name, promises.slop));
  }
  info.slop = promises.slop;
  info.slop_documented_by = promises.documented_by;
  info.settings.push_back(
      {"slop", fmt::format("{:.3g} m", promises.slop),
       fmt::format("a depth left between bodies in contact, documented by {}",
                   promises.documented_by)});
}

OracleInfo InfoOf(std::string name, const SimulatorPromises& promises) {
  OracleInfo info;
  info.name = std::move(name);
  info.library = "user";
  info.version = "unversioned";  // Not empty, because ledger entries name a version.
  info.unit_roundoff =
      promises.precision == Precision::kFloat ? kFloatRoundoff : kDoubleRoundoff;
  for (auto& row : info.capabilities) {
    for (Capability& capability : row)
      capability.reason = info.name + " moves worlds only";
  }
  info.simulates = true;
  for (WorldCapability& capability : info.world_capabilities)
    capability.reason = "not among what " + info.name + " simulates";
  for (const WorldFeature feature : promises.simulates)
    info.world_capabilities[static_cast<std::size_t>(feature)] = {true, ""};
  SetSlop(promises, info);
  return info;
}

class FunctionSimulator final : public Oracle {
 public:
  FunctionSimulator(OracleInfo info, BeginFunction begin)
      : info_(std::move(info)), begin_(std::move(begin)) {}

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      answers[i] = {};
      answers[i].reason = info_.name + " moves worlds only";
    }
  }

  std::unique_ptr<Simulation> Begin(const World& world) const override {
    return begin_(world);
  }

 private:
  OracleInfo info_;
  BeginFunction begin_;
};

}  // namespace

std::vector<WorldFeature> EverythingExcept(const std::vector<WorldFeature>& cannot) {
  std::vector<WorldFeature> features;
  for (int i = 0; i < kWorldFeatures; ++i) {
    const auto feature = static_cast<WorldFeature>(i);
    if (std::find(cannot.begin(), cannot.end(), feature) == cannot.end())
      features.push_back(feature);
  }
  return features;
}

std::unique_ptr<Oracle> MakeSimulator(std::string name, BeginFunction begin,
                                      const SimulatorPromises& promises) {
  return std::make_unique<FunctionSimulator>(InfoOf(std::move(name), promises),
                                             std::move(begin));
}

}  // namespace touchstone
