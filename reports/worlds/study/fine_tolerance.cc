#include "reports/worlds/study/fine_tolerance.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "reports/worlds/law_support/allowed_motion.h"

namespace touchstone {
namespace {

/** The largest tolerance of a pass as a share of the size of its question; see decision
 49. [-] */
constexpr double kFineShare = 0.01;

double HalfThicknessOf(const World& world) {
  double least = std::numeric_limits<double>::infinity();
  for (const RigidBody& body : world.bodies) {
    if (const Box* const box = std::get_if<Box>(&body.placed.shape))
      least = std::min(least, box->half_extents.minCoeff());
  }
  return least;
}

bool IsDepth(MeasureKind measure) {
  return measure == MeasureKind::kPenetration || measure == MeasureKind::kPassage;
}

/** Returns the size of which a fine tolerance is a share, as words. */
std::string_view SizedBy(std::string_view unit) {
  if (unit == "m") return "a hundredth of the smallest moving body";
  if (unit == "rad") return "a turn that moves a surface by a hundredth of its radius";
  if (unit == "m/s" || unit == "rad/s") return "a hundredth of the speed of the motion";
  if (unit == "N s") return "a hundredth of the momentum of the motion";
  if (unit == "N m s") return "a hundredth of the angular momentum of the motion";
  if (unit == "J") return "a hundredth of the energy of the motion";
  return "a hundredth";
}

}  // namespace

FineTolerance::FineTolerance(const Motion& motion)
    : scale_(ScaleOf(motion.world, AllowedMotion(motion).states())),
      half_thickness_(HalfThicknessOf(motion.world)) {}

double FineTolerance::Of(MeasureKind measure) const {
  if (!HasSize(measure)) return std::numeric_limits<double>::infinity();
  const double fine = kFineShare * SizeFor(measure, scale_);
  return IsDepth(measure) ? std::min(fine, half_thickness_) : fine;
}

void FineTolerance::Require(Finding& finding) const {
  const double fine = Of(finding.measure);
  if (finding.verdict != Verdict::kPass || finding.tolerance <= fine ||
      !RecognisedModelOf(finding).empty())
    return;
  const bool is_fine = finding.value <= fine;
  const std::string_view unit = UnitOf(finding.measure);
  finding.tolerance_because =
      fmt::format("{} {:.2g}{}{}, {}: {}", is_fine ? "narrowed to" : "wider than", fine,
                  unit.empty() ? "" : " ", unit,
                  IsDepth(finding.measure) && fine == half_thickness_
                      ? "half the thickness of the thinnest box"
                      : SizedBy(unit),
                  finding.tolerance_because);
  if (is_fine) {
    finding.tolerance = fine;
    finding.safety = 1;
    return;
  }
  finding.verdict = Verdict::kUndecidable;
  finding.undecided = Undecided::kCoarse;
}

}  // namespace touchstone
