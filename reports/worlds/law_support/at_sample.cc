#include "reports/worlds/law_support/at_sample.h"

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/citing.h"

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
  const MeasureKind measure = worst.finding().measure;
  // Velocities and spins are no points.
  const auto proof_of = [&](const auto& is_shown, const auto& truth_shown) {
    return Citing("{} has {} {} {} after {:.6g} s; {} {}", motion.oracle.name,
                  CitedName{name}, VerbOf(measure), is_shown,
                  CitedTime{motion.trajectory.times[sample]}, truth_is, truth_shown);
  };
  worst.Take((is - truth).norm(), tolerance, [&] {
    if (measure == MeasureKind::kPositionError)
      return proof_of(CitedPoint{is}, CitedPoint{truth});
    const ToldApart told = TellApart(is, truth, 9);
    return proof_of(told.a, told.b);
  });
}

}  // namespace touchstone
