#pragma once

#include <vector>

#include "oracles/oracle.h"
#include "reports/referee/contact_truth.h"
#include "reports/sweep/file_series.h"
#include "reports/sweep/question_series.h"
#include "reports/threads/stop.h"
#include "scenarios/scenario.h"

namespace touchstone {

/** Questions with their truths, in the order of their indices. */
struct TrueQuestions {
  std::vector<Scenario> scenarios;
  std::vector<ContactTruth> truths;
};

// Each of these returns fewer questions once it is told to stop.

/** Returns the questions of `block`, without an oracle's help. @pre block.climb == 1. */
TrueQuestions QuestionsOf(const QuestionSeries& block, const Stop& stop = nullptr);

/** Returns the questions of `block`. @pre block.questions. */
TrueQuestions QuestionsOf(const FileSeries& block, const Stop& stop = nullptr);

/** Returns the questions of `block` that a worst-case search puts to `subject`.

 The series is cut into climbs of `block.climb` questions at multiples of that number. A
 climb starts with the family's question of its first index. Each further question is the
 worst one so far with B moved, turned and resized at random, by 10^0 to 10^-6 of itself.
 A question is worse if the largest error of a length in the subject's answer, as a share
 of the smaller body, is larger; that of a wrong hit or miss is the certified distance.
 This is a (1+1) evolution strategy with random step sizes (Rechenberg, 1973).

 Question i is a pure function of the series, the subject and i: if the block starts in
 the middle of a climb, the climb is computed from its start.
 @pre block.climb > 1. */
TrueQuestions ClimbOf(const QuestionSeries& block, const Oracle& subject,
                      const Stop& stop = nullptr);

}  // namespace touchstone
