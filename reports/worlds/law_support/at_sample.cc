#include "reports/worlds/law_support/at_sample.h"

#include <fmt/format.h>

#include "reports/text/format_vector.h"

namespace touchstone {
namespace {

std::string_view VerbOf(MeasureKind measure) {
  if (measure == MeasureKind::kVelocityError) return "moving at";
  if (measure == MeasureKind::kSpinError) return "spinning at";
  return "at";
}

}  // namespace

void AtSample::Compare(Worst& worst, const Eigen::Vector3d& is,
                       const Eigen::Vector3d& truth, double tolerance,
                       std::string_view truth_is) const {
  worst.Take((is - truth).norm(), tolerance, [&] {
    return fmt::format("{} has {} {} {} after {:.6g} s; {} {}", motion.oracle.name, name,
                       VerbOf(worst.finding().measure), FormatVector(is, 9),
                       motion.trajectory.times[sample], truth_is, FormatVector(truth, 9));
  });
}

}  // namespace touchstone
