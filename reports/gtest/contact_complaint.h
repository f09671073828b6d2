#pragma once

#include <span>
#include <string>

#include "oracles/oracle.h"
#include "reports/sweep/question_series.h"

namespace touchstone {

/** Returns the faults of `subject` on the series, written for a person; empty where there
 are none. It states how many questions the subject failed. The first of them is made
 smaller, Shrink(), while its fault persists; it shows the file, every answer with its
 proof, and the command that repeats the first. A series in which
 no bodies touch, or which the subject does not support, is a fault too. The answers of
 `references` are shown next to the subject's. */
std::string ComplaintAbout(const Oracle& subject, const QuestionSeries& series,
                           std::span<const Oracle* const> references = {});

}  // namespace touchstone
