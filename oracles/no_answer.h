#pragma once

#include <string>

#include "oracles/contact_answer.h"

namespace touchstone {

/** Returns the answer of an oracle that has no such query, and why. */
ContactAnswer UnsupportedAnswer(std::string reason);

/** Returns the answer of an oracle whose engine broke down over the question, and how. */
ContactAnswer CrashedAnswer(std::string reason);

/** Returns the answer of an oracle whose engine worked on the question up to a limit, and
 * which. */
ContactAnswer TimedOutAnswer(std::string reason);

/** Returns kCrashed with "threw std::logic_error: <what>". To be called in a catch block
 * only. */
ContactAnswer CrashedByException();

}  // namespace touchstone
