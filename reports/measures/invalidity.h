#pragma once

#include <optional>
#include <string>

#include "oracles/contact_answer.h"

namespace touchstone {

/** The reason why an answer is invalid. */
struct Invalidity {
  std::string what;  ///< E.g. "n_AB_W is not finite".
  /** How much the length of a normal differs from 1, if by less than a half: it still is
   a direction. Empty for other reasons. [-] */
  std::optional<double> off_unit = std::nullopt;
};

/** Returns the gravest reason why an answer is invalid, or nothing. Invalid are NaN and
 infinities anywhere, a normal whose length differs from 1 by more than `unit_slack` [-],
 and a contact without a normal in an answer that has none of its own. An invalid answer
 is judged no further: a NaN compares false with everything, and could pass. */
std::optional<Invalidity> InvalidityOf(const ContactAnswer& answer, double unit_slack);

}  // namespace touchstone
