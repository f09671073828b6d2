#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/run_report.h"
#include "reports/shrink/question.h"
#include "reports/triage/symptom.h"

namespace touchstone {

/** A question that shows symptoms. */
struct Specimen {
  std::vector<Symptom> symptoms;           ///< Those it stands for, the gravest first.
  std::vector<std::string> failures = {};  ///< What goes wrong in them, see Joined().
  const Oracle* oracle = nullptr;
  /** The gravest question of the first symptom that shows it again; if none does, the
   gravest. */
  Question original;
  /** Whether the oracle failed `original` again. If not, nothing below is set. */
  bool is_repeatable = false;
  Question question;
  RunReport report;  ///< That of AskAlone(question, *oracle).
  /** The fault: at first the decisive one of the answer or, if that is right, of a
   variant; of the smallest question the same fault. One of `report`. */
  Finding finding;
  bool is_smallest = false;           ///< Same as Shrunk::is_smallest.
  std::optional<std::size_t> shifts;  ///< Same as Shrunk::shifts.
};

/** Returns whether it is a measure of a variant of a contact question: swap,
 rigid_motion, scaling, relabelling or perturbation. */
bool IsOfAVariant(MeasureKind measure);

/** Returns whether a fault is one of the normal alone: another direction is shorter, or a
 depth that is right does not belong to it. */
bool IsOfANormal(const RunReport& report, const Finding& finding);

/** Asks the kept questions of a symptom again, until one shows it. Where a variant of the
 question is answered wrongly, the variant becomes the question, if the oracle is wrong
 about it alone; else a fault of the answer itself is taken, if there is one. */
Specimen AskAgain(const Symptom& symptom, const Oracle& oracle);

/** The limits of a search for the smallest question. */
struct SmallestOptions {
  std::size_t tries = 300;               ///< Same as ShrinkOptions::tries.
  std::function<bool()> stop = nullptr;  ///< Same as ShrinkOptions::stop.
};

/** Returns `specimen` with the smallest question that shows its fault. Gives up where the
 engine hangs ten times. @pre It is repeatable. */
Specimen Smallest(Specimen specimen, const SmallestOptions& options);

}  // namespace touchstone
