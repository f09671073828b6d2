#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The worst of many numbers of one measure, each with a tolerance of its own: tolerances
 grow with time, so the largest number need not be the one that is most wrong. */
class Worst {
 public:
  Worst(MeasureKind measure, std::string because) {
    finding_.measure = measure;
    finding_.tolerance.because = std::move(because);
  }

  /** Takes a number; `proof()` is called, for its sentence, only where it is the worst so
   far. */
  template <typename Proof>
  void Take(double value, double tolerance, Proof&& proof) {
    // What is exact is never the worst, even where nothing is allowed. Written so that a
    // NaN is the worst of all.
    const double share = value == 0 ? 0 : value / tolerance;
    if (share <= share_ || std::isnan(share_)) return;
    share_ = share;
    finding_.value = value;
    finding_.tolerance.value = tolerance;
    finding_.proof = proof();
  }

  /** Whether there was any number to take. */
  bool IsTaken() const { return !(share_ < 0); }

  /** Whether the worst is beyond its tolerance. */
  bool IsBeyond() const { return !(finding_.value <= finding_.tolerance.value); }

  /** The law's finding: its fields hold the worst number. */
  const LawFinding& finding() const { return finding_; }

  /** Returns the finding, recognised as that of a legal model where it is beyond its
   tolerance. */
  LawFinding RecognisedAs(std::string_view model) const {
    LawFinding finding = finding_;
    if (IsBeyond()) finding.recognised = model;
    return finding;
  }

 private:
  LawFinding finding_;
  double share_ = -1;  ///< Of the worst: its value in tolerances.
};

/** Returns whether the worst of any measure is beyond its tolerance. */
bool AnyBeyond(const std::vector<Worst>& findings);

/** Returns the findings of what there was to measure, recognised as `model` where they
 are beyond their tolerance; empty: no model. */
std::vector<LawFinding> FindingsOf(const std::vector<Worst>& findings,
                                   std::string_view model = "");

/** Returns one finding for each measure: of several, one that is beyond its tolerance and
 not recognised before one that is recognised, and that before one within; among equals
 the one that is most tolerances large. */
std::vector<LawFinding> WorstOfEach(const std::vector<LawFinding>& findings);

}  // namespace touchstone
