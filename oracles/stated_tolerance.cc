#include "oracles/stated_tolerance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "oracles/forwarding_oracle.h"

namespace touchstone {
namespace {

constexpr const char* kSetting = "tolerance";

class TolerantOracle final : public ForwardingOracle {
 public:
  TolerantOracle(const Oracle& oracle, StatedTolerance tolerance)
      : ForwardingOracle(oracle) {
    SetTolerance(std::move(tolerance), info_);
  }
  TolerantOracle(std::unique_ptr<Oracle> oracle, StatedTolerance tolerance)
      : TolerantOracle(*oracle, std::move(tolerance)) {
    owned_ = std::move(oracle);
  }

  std::unique_ptr<Oracle> SetUp(const WorldSetup& setup) const override {
    return std::make_unique<TolerantOracle>(oracle_.SetUp(setup), info_.tolerance);
  }

 private:
  std::unique_ptr<Oracle> owned_;  ///< Null, or `oracle_`.
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
