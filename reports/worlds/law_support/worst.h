#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The worst of many numbers of one measure, each with its own tolerance, and the largest
 within its own. Tolerances grow with time, so the two may differ. */
class Worst {
 public:
  Worst(MeasureKind measure, std::string because, Grants grants = Grants::kStep) {
    finding_.measure = measure;
    finding_.grants = grants;
    finding_.tolerance.because = std::move(because);
  }

  /** Takes a number; `proof()`, a CitingProof, is called only if the number is the worst
   so far. */
  template <typename Proof>
  void Take(double value, double tolerance, Proof&& proof) {
    if (value <= tolerance && value > finding_.largest.value)
      finding_.largest = {value, tolerance};
    // A value of zero is never the worst, even with a tolerance of zero. Written so that
    // a NaN is the worst of all.
    const double share = value == 0 ? 0 : value / tolerance;
    if (share <= share_ || std::isnan(share_)) return;
    share_ = share;
    finding_.value = value;
    finding_.tolerance.value = tolerance;
    CitingProof of_value = proof();
    finding_.proof = std::move(of_value.sentence);
    finding_.cited = std::move(of_value.cited);
    // Numbers are taken in the order of time, so the first that is beyond its tolerance
    // is also the worst until then. Numbers of another body may be taken after it.
    if (IsBeyond() && finding_.cited.time)
      first_time_ = std::min(first_time_, *finding_.cited.time);
    if (first_time_ < HUGE_VAL) finding_.cited.first_time = first_time_;
  }

  /** Returns whether any number was taken. */
  bool IsTaken() const { return !(share_ < 0); }

  /** Returns the worst number over its tolerance, InTolerances(); negative if none was
   taken. [-] */
  double share() const { return std::isnan(share_) ? HUGE_VAL : share_; }

  /** Returns whether the worst number is beyond its tolerance. */
  bool IsBeyond() const { return touchstone::IsBeyond(finding_); }

  /** Returns the law's finding; its fields hold the worst number. */
  const LawFinding& finding() const { return finding_; }

  /** Returns the finding, recognised as that of a legal model if it is beyond its
   tolerance. */
  LawFinding RecognisedAs(std::string_view model) const;

 private:
  LawFinding finding_;
  double share_ = -1;             ///< The worst value over its tolerance.
  double first_time_ = HUGE_VAL;  ///< The first moment beyond its tolerance. [s]
};

/** Returns whether the worst number of any measure is beyond its tolerance. */
bool AnyBeyond(const std::vector<Worst>& findings);

/** Returns the findings of all measures that took a number, recognised as `model` if they
 are beyond their tolerance; empty: no model. */
std::vector<LawFinding> FindingsOf(const std::vector<Worst>& findings,
                                   std::string_view model = "");

/** Returns one finding per measure of subjects that `judge` judges one by one. A finding
 beyond its tolerance and not recognised precedes a recognised one, and that precedes one
 within its tolerance; among equals NaN is taken, then the largest value over
 tolerance. */
std::vector<LawFinding> WorstOfEach(
    const std::vector<int>& subjects,
    const std::function<std::vector<LawFinding>(int subject)>& judge);

}  // namespace touchstone
