#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "oracles/oracle.h"
#include "reports/contacts/tolerance_reasons.h"
#include "reports/contacts/tolerances.h"
#include "reports/finding/finding.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** A measured value and its tolerance, which RulingOn() turns into a verdict. */
struct Measured {
  MeasureKind measure;
  double value;
  double tolerance;
  /** The value if the truth lies at that end of its enclosure which is worst for the
   answer. Where the enclosure is wider than the tolerance, a pass needs it to be within
   the tolerance, too. */
  std::optional<double> worst = {};
  /** Why a value beyond the tolerance proves nothing; empty if it is a proof. */
  std::string_view unproved = {};
};

/** One answer to a contact query, what its checks share, and what they have found. It
 refers to the arguments of its constructor. A check is a function of one file in this
 folder: it adds the finding of its measure where that measure applies. */
class JudgedAnswer {
 public:
  JudgedAnswer(const Scenario& scenario, const ContactTruth& truth,
               const OracleInfo& oracle, const ContactAnswer& answer, Reasons reasons);
  JudgedAnswer(const JudgedAnswer&) = delete;  // `because` refers to `tolerances`.

  const ContactQuery& query;
  const ContactTruth& truth;
  const OracleInfo& oracle;
  const ContactAnswer& answer;
  const Capability& capability;  ///< Of the oracle for this pair of shapes.
  const Tolerances tolerances;
  const ToleranceReasons because;
  const std::optional<Eigen::Vector3d> n_W;  ///< The unit normal that the answer states.
  const std::optional<double> separation;    ///< The one that the answer states. [m]

  /** Whether the normal was found right: a patch belongs to a normal. */
  bool normal_is_right = false;
  /** Whether all contacts were found to have their points on both surfaces. */
  bool points_are_right = false;

  /** Returns whether the answer states a normal that claims to be the direction of the
   least translation, or of the distance. */
  bool ClaimsLeastDirection() const;

  /** Returns the overlap along the normal of the answer. Evaluated once: several checks
   need it, and it is most of the cost of some.
   @pre The answer states a normal. */
  const Enclosure& Along();

  /** Returns the separation along SupportingDirection() of the normal, midway through its
   enclosure. [m]
   @pre The answer states a normal. */
  double SupportedSeparation();

  /** Adds the finding on what was measured, and returns its verdict. `reason` is called
   for the reason of the tolerance if the finding carries it, and `prove` for the Proof of
   a failure. */
  template <typename Reason, typename Prove>
  Verdict Judge(const Measured& measured, Reason reason, Prove prove) {
    Ruling ruling = RulingOn(measured);
    Finding& finding = Add(measured.measure, measured.value, ruling.tolerance);
    finding.verdict = ruling.verdict;
    finding.undecided = ruling.undecided;
    if (reasons_ == Reasons::kOfAll)
      finding.tolerance_because = std::move(ruling.qualification) + reason();
    if (ruling.verdict == Verdict::kFail) {
      if (reasons_ != Reasons::kNone) State(prove(), finding);
      SetGrade(finding);
    }
    return ruling.verdict;
  }

  /** Adds the finding that a value cannot be judged, for that reason. */
  template <typename Reason>
  void LeaveUndecided(MeasureKind measure, double value, double tolerance,
                      Undecided undecided, Reason reason) {
    Finding& finding = Add(measure, value, tolerance);
    finding.verdict = Verdict::kUndecidable;
    finding.undecided = undecided;
    if (reasons_ == Reasons::kOfAll) finding.tolerance_because = reason();
  }

  /** Adds the finding on whether there is an answer: a pass, or why there is none. */
  Finding& AddAnswering(Verdict verdict, std::string_view why);

  /** Returns what was found, in the order in which it was added. */
  std::vector<Finding> Findings() && { return std::move(findings_); }

 private:
  struct Ruling {
    Verdict verdict;
    double tolerance;
    Undecided undecided = Undecided::kUnknown;
    std::string qualification = {};  ///< Begins the reason of the tolerance.
  };

  /** Returns the verdict on what was measured. */
  Ruling RulingOn(const Measured& measured) const;

  Finding& Add(MeasureKind measure, double value, double tolerance);

  /** Sets how bad a failure is. */
  void SetGrade(Finding& finding) const;

  const std::string& scenario_;
  const Reasons reasons_;
  std::optional<Enclosure> along_;  ///< Along(), once it is known.
  std::vector<Finding> findings_;
};

}  // namespace touchstone
