#pragma once

#include <oracles/function_oracle.h>

#include "my_box_box.h"

/** Converts Touchstone's question to the types of CollideBoxes(), and its answer back. */
inline touchstone::ContactAnswer AskMyBoxBox(const touchstone::Box& A,
                                             const touchstone::Pose& X_WA,
                                             const touchstone::Box& B,
                                             const touchstone::Pose& X_WB) {
  const Hit hit = CollideBoxes({A.half_extents, X_WA.R_WB, X_WA.p_WB},
                               {B.half_extents, X_WB.R_WB, X_WB.p_WB});
  touchstone::ContactAnswer answer;
  answer.status = touchstone::AnswerStatus::kAnswered;
  answer.touching = hit.touching;
  if (hit.touching) {
    answer.n_AB_W = hit.normal;      // From A to B.
    answer.separation = -hit.depth;  // Negative when penetrating.
  }
  return answer;
}
