#include "reports/contacts/tolerance_reasons.h"

#include <cmath>

#include <fmt/format.h>

#include "oracles/stated_tolerance.h"
#include "reports/contacts/body_size.h"

namespace touchstone {

std::string ToleranceReasons::Length(double size) const {
  const ContactQuery& query = scenario_.contact;
  std::string because = fmt::format(
      "{} roundings of 2^{:.0f} on a scene of {:.3g} m, and {:.2g} m for the rounding of "
      "the input",
      kRoundings, std::log2(oracle_.unit_roundoff), size, truth_.input_rounding);
  const double documented = DocumentedFor(oracle_, query, truth_);
  if (documented > 0) {
    because += fmt::format(
        "; {:.2g} m, {:.2g} of the smallest feature, documented by {}", documented,
        documented / SmallestFeature(query),
        oracle_.For(KindOf(query.A.shape), KindOf(query.B.shape)).documented_by);
  }
  if (!oracle_.tolerance.IsZero()) {
    because +=
        fmt::format("; {:.2g} m granted, {} stated by {}", StatedFor(oracle_, query),
                    ToString(oracle_.tolerance), oracle_.tolerance.by);
  }
  if (scenario_.tolerance) {
    because += fmt::format("; {:.2g} m granted by the scenario: {}",
                           scenario_.tolerance->separation, scenario_.tolerance->because);
  }
  return because;
}

std::string ToleranceReasons::Separation() const {
  return Length(RoundedSize(oracle_, scenario_.contact));
}

std::string ToleranceReasons::Position() const {
  return Length(SceneSize(scenario_.contact));
}

std::string ToleranceReasons::Apart() const {
  if (!(truth_.separation.lo > 0) || touching_) return Separation();
  return fmt::format(
      "{}; {:.2g} m for the direction between points {:.3g} m apart, each off by {:.2g} "
      "m",
      Separation(), tolerances_.apart - tolerances_.separation, truth_.separation.lo,
      tolerances_.separation);
}

std::string ToleranceReasons::Excess() const {
  return fmt::format("{}; {:.2g} m more, since a direction is chosen among rounded ones",
                     Apart(), tolerances_.excess - tolerances_.apart);
}

std::string ToleranceReasons::Across() const {
  const double extent = SmallerExtent(scenario_.contact);
  const double off = tolerances_.position;
  return fmt::format(
      "a depth off by {:.2g} m leaves the deepest point of a body {:.3g} m wide "
      "uncertain by 2 sqrt(2 * {:.2g} * {:.3g}) m across the normal",
      off, extent, off, extent);
}

std::string ToleranceReasons::Angle() const {
  return fmt::format("lengths off by {:.2g} m tilt a feature of {:.3g} m",
                     tolerances_.separation, SmallestFeature(scenario_.contact));
}

}  // namespace touchstone
