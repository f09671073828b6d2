#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "oracles/contact_answer.h"
#include "oracles/protocol/message.h"

namespace touchstone {

/** Adds `answers` to `message`, as "answers", or in the frame if `in_frame`.

 A frame holds for each answer: status (0 answered, 1 unsupported, 2 error), touching (0
 or 1), what is provided (1 normal + 2 separation + 4 witnesses), normal (3), separation,
 witnesses (3 of A, 3 of B), the number n of points, and n points, each: position (3),
 separation, whether it has a normal (0 or 1), normal (3). The reasons are in the line,
 "reasons", by the index of the answer. */
void PutAnswers(std::span<const ContactAnswer> answers, bool in_frame, Message& message);

/** Returns the `count` answers that `message` holds. An answer that does not follow the
 protocol is kCrashed, with the error as its reason; the others are not touched by it.
 @throws ProtocolError if their number is another, or if a frame cannot be read. */
std::vector<ContactAnswer> AnswersFrom(const Message& message, std::size_t count);

}  // namespace touchstone
