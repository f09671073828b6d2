#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** The worst of many numbers of one measure, each with its own tolerance. Tolerances grow
 with time, so the largest number need not be the worst one. */
class Worst {
 public:
  Worst(MeasureKind measure, std::string because, Grants grants = Grants::kStep) {
    finding_.measure = measure;
    finding_.grants = grants;
    finding_.tolerance.because = std::move(because);
  }

  /** Takes a number; `proof()` is called, for its sentence, only if the number is the
   worst so far. */
  template <typename Proof>
  void Take(double value, double tolerance, Proof&& proof) {
    // A value of zero is never the worst, even with a tolerance of zero. Written so that
    // a NaN is the worst of all.
    const double share = value == 0 ? 0 : value / tolerance;
    if (share <= share_ || std::isnan(share_)) return;
    share_ = share;
    finding_.value = value;
    finding_.tolerance.value = tolerance;
    finding_.proof = proof();
  }

  /** Returns whether any number was taken. */
  bool IsTaken() const { return !(share_ < 0); }

  /** Returns whether the worst number is beyond its tolerance. */
  bool IsBeyond() const { return !(finding_.value <= finding_.tolerance.value); }

  /** Returns the law's finding; its fields hold the worst number. */
  const LawFinding& finding() const { return finding_; }

  /** Returns the finding, recognised as that of a legal model if it is beyond its
   tolerance. */
  LawFinding RecognisedAs(std::string_view model) const {
    LawFinding finding = finding_;
    if (IsBeyond()) finding.recognised = model;
    return finding;
  }

 private:
  LawFinding finding_;
  double share_ = -1;  ///< The worst value over its tolerance.
};

/** Returns whether the worst number of any measure is beyond its tolerance. */
bool AnyBeyond(const std::vector<Worst>& findings);

/** Returns the findings of all measures that took a number, recognised as `model` if they
 are beyond their tolerance; empty: no model. */
std::vector<LawFinding> FindingsOf(const std::vector<Worst>& findings,
                                   std::string_view model = "");

/** Returns one finding per measure of subjects that `judge` judges one by one. A finding
 beyond its tolerance and not recognised precedes a recognised one, and that precedes one
 within its tolerance; among equals the one with the largest value over tolerance is
 taken. */
std::vector<LawFinding> WorstOfEach(
    const std::vector<int>& subjects,
    const std::function<std::vector<LawFinding>(int subject)>& judge);

}  // namespace touchstone
