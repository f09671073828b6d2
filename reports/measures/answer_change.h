#pragma once

#include <algorithm>

#include <Eigen/Geometry>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** How much two answers to one question differ. [m] */
struct AnswerDifference {
  /** |s − s'|; where one says touching and the other apart at least the certified
   distance from touching, so that nobody is blamed within the rounding of a touching
   pair. */
  double separation = 0;
  /** |o(n) − o(n')|, which compares normals by what they separate: a tie is no change. */
  double overlap = 0;
  bool compared = false;  ///< Whether there was a separation or a normal to compare.

  double Largest() const { return std::max(separation, overlap); }
};

/** Returns how much two answers to one question differ in what they state
 (reports/measures/stated.h). Positions are not compared: manifolds may legally differ.

 The metamorphic measures: the answer to a changed question, brought back by the functions
 below, against the answer to the question itself. They need no reference.
 Source: Chen, Cheung & Yiu, "Metamorphic testing", HKUST-CS98-01 (1998). */
AnswerDifference AnswerChange(const ContactQuery& query, const ContactTruth& truth,
                              const ContactAnswer& answer,
                              const ContactAnswer& brought_back);

/** Brings the answer to (B, A) back to (A, B): negates normals, swaps witnesses. */
ContactAnswer BackFromSwap(ContactAnswer answer);

/** Brings the answer back from the world frame W' = X_W'W W of a moved question. */
ContactAnswer BackFromMotion(ContactAnswer answer, const Eigen::Isometry3d& X_VW);

/** Brings the answer back from a world in which all lengths are `factor` times as long.
 */
ContactAnswer BackFromScale(ContactAnswer answer, double factor);

}  // namespace touchstone
