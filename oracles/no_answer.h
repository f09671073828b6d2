#pragma once

#include <string>

#include "oracles/contact_answer.h"

namespace touchstone {

/** Returns the answer of an oracle that does not support the query, with the reason. */
ContactAnswer UnsupportedAnswer(std::string reason);

/** Returns the answer of an oracle whose engine failed on the query, with the reason. */
ContactAnswer CrashedAnswer(std::string reason);

/** Returns the answer of an oracle whose engine reached a limit, named by `reason`, while
 working on the query. */
ContactAnswer TimedOutAnswer(std::string reason);

/** Returns kCrashed with "threw std::logic_error: <what>". To be called in a catch block
 * only. */
ContactAnswer CrashedByException();

}  // namespace touchstone
