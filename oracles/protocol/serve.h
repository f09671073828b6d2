#pragma once

#include "oracles/oracle.h"

namespace touchstone {

/** Answers the messages of the oracle protocol (docs/oracle_protocol.md) that arrive at
 the descriptor `input` for `oracle`, and writes the answers to `output`, until "bye" or
 the end of the input. A message that cannot be understood is answered with an error.
 Returns whether every answer could be written. */
bool Serve(const Oracle& oracle, int input, int output);

}  // namespace touchstone
