#pragma once

#include <cstddef>
#include <span>

#include "oracles/no_answer.h"
#include "oracles/oracle.h"

namespace touchstone {

/** Answers each query by itself: where `info` does not support the pair with the reason,
 else with `answer_one(query)`. What that throws is kCrashed, and the next query is asked.
 @pre The sizes are equal. */
template <class AnswerOne>
void AnswerEach(const OracleInfo& info, std::span<const ContactQuery> queries,
                std::span<ContactAnswer> answers, AnswerOne answer_one) {
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const ContactQuery& query = queries[i];
    const Capability& capability = info.For(KindOf(query.A.shape), KindOf(query.B.shape));
    if (!capability.supported) {
      answers[i] = UnsupportedAnswer(capability.reason);
      continue;
    }
    try {
      answers[i] = answer_one(query);
    } catch (...) {
      answers[i] = CrashedByException();
    }
  }
}

}  // namespace touchstone
