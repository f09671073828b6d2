#pragma once

#include <optional>
#include <string>

#include "oracles/contact_answer.h"

namespace touchstone {

/** Returns the reason why an answer is invalid, e.g. "n_AB_W is not finite", or nothing.
 Invalid are NaN and infinities anywhere, a normal whose length differs from 1 by more
 than `unit_slack` [-], and a contact without a normal in an answer that has none of its
 own. An invalid answer is judged no further: a NaN compares false with everything, and
 could pass. */
std::optional<std::string> InvalidityOf(const ContactAnswer& answer, double unit_slack);

}  // namespace touchstone
