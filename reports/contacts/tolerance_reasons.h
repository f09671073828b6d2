#pragma once

#include <string>

#include "reports/contacts/tolerances.h"

namespace touchstone {

/** Which findings carry the reason of their tolerance and their proof, in sentences. */
enum class Reasons {
  kOfAll,
  kNoneButProofs,  ///< None; failures have proofs. Millions of findings are counted.
  kNone,           ///< None, and no proofs: only verdicts are asked for.
};

/** Words the tolerances of one oracle in one scenario, one sentence each, quoted in the
 report. Sentences cost more than judging, so they are made on demand. It refers to its
 arguments, those of TolerancesOf() and its result. */
class ToleranceReasons {
 public:
  ToleranceReasons(const OracleInfo& oracle, const Scenario& scenario,
                   const ContactTruth& truth, bool touching, const Tolerances& tolerances)
      : oracle_(oracle),
        scenario_(scenario),
        truth_(truth),
        touching_(touching),
        tolerances_(tolerances) {}

  std::string Separation() const;
  std::string Position() const;
  std::string Apart() const;
  std::string Excess() const;
  std::string Across() const;
  std::string Angle() const;

 private:
  /** Words the tolerance of a length for roundings of `size` [m]. */
  std::string Length(double size) const;

  const OracleInfo& oracle_;
  const Scenario& scenario_;
  const ContactTruth& truth_;
  bool touching_;
  const Tolerances& tolerances_;
};

}  // namespace touchstone
