#pragma once

#include <string>

#include "oracles/oracle.h"
#include "oracles/protocol/message.h"

namespace touchstone {

/** Adds the description of an oracle to the answer to "hello": everything in `info` but
 what Touchstone itself sets. `frames` says whether it takes and gives frames. */
void PutHello(const OracleInfo& info, bool frames, Message& message);

/** What a program says of itself. */
struct Hello {
  OracleInfo info;
  bool frames = false;
};

/** Returns the description in the answer to "hello". The oracle is called `name`, or as
 it calls itself if that is empty.
 @throws ProtocolError if it is not one, or is of another version of the protocol; for an
 error beyond rounding or a slop without its source. */
Hello HelloFrom(const Message& message, const std::string& name = "");

}  // namespace touchstone
