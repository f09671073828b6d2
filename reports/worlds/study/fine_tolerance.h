#pragma once

#include "reports/finding/finding.h"
#include "reports/worlds/law_support/law.h"
#include "reports/worlds/study/motion_scale.h"

namespace touchstone {

/** The largest tolerance with which a measure of one motion can pass. It is 1 % of
 SizeFor() the measure: of the smallest body, of the speed, of the energy, and so on. For
 angles it is 0.01 rad, because such a rotation moves a surface by 1 % of its radius. For
 penetration it is at most half the thickness of the thinnest box. The scale is that of
 the AllowedMotion: an engine that gains speed does not get larger tolerances. */
class FineTolerance {
 public:
  explicit FineTolerance(const Motion& motion);

  /** Returns the largest tolerance of a pass; infinite for measures without a size, see
   HasSize(). [unit of the measure] */
  double Of(MeasureKind measure) const;

  /** Narrows a wider tolerance of a pass to Of(). A value that passes only the wider one
   becomes `undecidable`: nothing shows that it is right. Leaves every other verdict, and
   a recognised model, as it is. */
  void Require(Finding& finding) const;

 private:
  MotionScale scale_;
  double half_thickness_;  ///< Half the least extent of a box. [m]
};

}  // namespace touchstone
