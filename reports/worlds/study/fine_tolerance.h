#pragma once

#include "reports/finding/finding.h"
#include "reports/worlds/law_support/law.h"
#include "reports/worlds/study/motion_scale.h"

namespace touchstone {

/** The largest tolerances of a pass of one motion: a hundredth of the size by which
 ShareOf() divides. Of an angle it is 0.01 rad, which moves a surface by a hundredth of
 its radius; of a depth, no more than half the thickness of the thinnest box. The speed is
 that of the AllowedMotion, so that no engine widens them by its own speed. */
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
