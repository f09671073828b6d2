#pragma once

namespace touchstone {

class JudgedAnswer;

/** Returns whether there is an answer, of valid numbers. Adds the finding that there is
 none. */
bool CheckIsAnswered(JudgedAnswer& judged);

/** Returns whether an answer has all fields that the oracle promises for the pair of
 shapes. Adds the finding that one is missing. */
bool CheckIsComplete(JudgedAnswer& judged);

}  // namespace touchstone
