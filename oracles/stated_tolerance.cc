#include "oracles/stated_tolerance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace touchstone {
namespace {

constexpr const char* kSetting = "tolerance";

class TolerantOracle final : public Oracle {
 public:
  TolerantOracle(const Oracle& oracle, StatedTolerance tolerance)
      : oracle_(oracle), info_(oracle.info()) {
    SetTolerance(std::move(tolerance), info_);
  }
  TolerantOracle(std::unique_ptr<Oracle> oracle, StatedTolerance tolerance)
      : TolerantOracle(*oracle, std::move(tolerance)) {
    owned_ = std::move(oracle);
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    oracle_.Answer(queries, answers);
  }
  std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const override {
    return oracle_.Prepare(queries);
  }
  std::string CannotSimulate(const World& world) const override {
    return oracle_.CannotSimulate(world);
  }
  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    return oracle_.BeginWith(world, values);
  }
  std::unique_ptr<Simulation> Begin(const World& world) const override {
    return oracle_.Begin(world);
  }
  std::unique_ptr<Simulation> BeginAsShipped(const World& world) const override {
    return oracle_.BeginAsShipped(world);
  }
  std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                             int threads) const override {
    return oracle_.BeginInThreads(world, threads);
  }
  std::unique_ptr<Oracle> SetUp(const WorldSetup& setup) const override {
    return std::make_unique<TolerantOracle>(oracle_.SetUp(setup), info_.tolerance);
  }
  Trajectory Simulate(const World& world) const override {
    return oracle_.Simulate(world);
  }
  std::vector<Trajectory> SimulateEach(std::span<const World> worlds) const override {
    return oracle_.SimulateEach(worlds);
  }

 private:
  const Oracle& oracle_;
  std::unique_ptr<Oracle> owned_;  ///< Null, or `oracle_`.
  OracleInfo info_;
};

void CheckPart(double part, const char* name) {
  if (std::isfinite(part) && part >= 0) return;
  throw std::invalid_argument(fmt::format(
      "the {} of a tolerance is {}; expected a finite number >= 0", name, part));
}

}  // namespace

void SetTolerance(StatedTolerance tolerance, OracleInfo& info) {
  CheckPart(tolerance.length, "length");
  CheckPart(tolerance.share, "share");
  if (!tolerance.IsZero() && tolerance.by.empty()) {
    throw std::invalid_argument(
        fmt::format("{} has a tolerance of {} without a source; expected one, e.g. "
                    ".documented_by = \"its manual, section 4\"",
                    info.name, ToString(tolerance)));
  }
  std::erase_if(info.settings,
                [](const Setting& setting) { return setting.name == kSetting; });
  if (!tolerance.IsZero()) {
    info.settings.push_back(
        {kSetting, ToString(tolerance),
         fmt::format("granted beyond rounding, as stated by {}", tolerance.by)});
  }
  info.tolerance = std::move(tolerance);
}

std::unique_ptr<Oracle> WithTolerance(const Oracle& oracle, StatedTolerance tolerance) {
  return std::make_unique<TolerantOracle>(oracle, std::move(tolerance));
}

std::string ToString(const StatedTolerance& tolerance) {
  const std::string share = fmt::format("{:.3g} of the scene's size", tolerance.share);
  if (tolerance.share == 0) return fmt::format("{:.3g} m", tolerance.length);
  if (tolerance.length == 0) return share;
  return fmt::format("{:.3g} m and {}", tolerance.length, share);
}

}  // namespace touchstone
