#pragma once

#include <algorithm>

#include <Eigen/Geometry>

#include "oracles/contact_answer.h"
#include "reports/referee/contact_truth.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** The difference of two answers to one question. [m] */
struct AnswerDifference {
  /** |s − s'|. If one answer says touching and the other apart, at least the certified
   distance from touching: no engine is blamed within the rounding of a touching pair. */
  double separation = 0;
  /** |o(n) − o(n')|. Normals are compared by the overlap along them, so a tie is no
   change. */
  double overlap = 0;
  bool compared =
      false;  ///< Whether both answers had a separation or a normal to compare.

  double Largest() const { return std::max(separation, overlap); }
};

/** Returns the difference of two answers to one question in the fields that they state
 (reports/measures/stated.h). Positions are not compared, since manifolds may legally
 differ.

 The metamorphic measures compare the answer to a changed question, mapped back by the
 functions below, with the answer to the original question. They need no reference.
 Source: Chen, Cheung & Yiu, "Metamorphic testing", HKUST-CS98-01 (1998). */
AnswerDifference AnswerChange(const ContactQuery& query, const ContactTruth& truth,
                              const ContactAnswer& answer,
                              const ContactAnswer& brought_back);

/** Maps the answer to (B, A) back to (A, B): negates normals, swaps witnesses. */
ContactAnswer BackFromSwap(ContactAnswer answer);

/** Maps the answer to a moved question back from its frame V; X_VW is the motion applied
 to the question. */
ContactAnswer BackFromMotion(ContactAnswer answer, const Eigen::Isometry3d& X_VW);

/** Maps the answer back from a world in which all lengths are `factor` times as long. */
ContactAnswer BackFromScale(ContactAnswer answer, double factor);

}  // namespace touchstone
