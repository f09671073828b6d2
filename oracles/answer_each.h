#pragma once

#include <cstddef>
#include <span>

#include "oracles/no_answer.h"
#include "oracles/oracle.h"
#include "oracles/stopwatch.h"

namespace touchstone {

/** Answers each query independently. A pair that `info` does not support is answered with
 the reason, any other with `answer_one(query)`. An exception becomes kCrashed, and the
 next query is answered. Each answer states its time. @pre The sizes are equal. */
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
    const Stopwatch watch;
    try {
      answers[i] = answer_one(query);
    } catch (...) {
      answers[i] = CrashedByException();
    }
    answers[i].seconds = watch.seconds();
  }
}

}  // namespace touchstone
