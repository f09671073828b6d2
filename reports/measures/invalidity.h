#pragma once

#include <optional>
#include <string>

#include "oracles/contact_answer.h"

namespace touchstone {

/** Returns what makes an answer no answer, e.g. "n_AB_W is not finite", or nothing.

 NaN and infinities anywhere, a normal whose length differs from 1 by more than
 `unit_slack` [-], a contact without normal of its own in an answer that has none. Not
 judged further: a NaN compares false with everything and would slip through. */
std::optional<std::string> InvalidityOf(const ContactAnswer& answer, double unit_slack);

}  // namespace touchstone
