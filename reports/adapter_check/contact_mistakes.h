#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "oracles/contact_answer.h"
#include "scenarios/contact_query.h"

namespace touchstone {

/** A mistake that adapters make with contact questions, as the question that the engine
 was in effect asked, or as the answer that it in effect gave. */
struct ContactMistake {
  std::string sentence;  ///< What the adapter does: "takes half extents for edges".
  /** Returns the question that the adapter with this mistake puts to its engine; nothing
   if the mistake changes nothing about it. Empty for a mistake in the answer. */
  std::function<std::optional<ContactQuery>(const ContactQuery&)> asked;
  /** Returns the answer as it was before the adapter made the mistake; nothing if the
   mistake changes nothing about it. Empty for a mistake in the question. */
  std::function<std::optional<ContactAnswer>(const ContactQuery&, const ContactAnswer&)>
      meant;
};

/** Returns the mistakes that we know, the simpler ones first. Sources: the conventions of
 the engines of docs/conventions.md. */
const std::vector<ContactMistake>& ContactMistakes();

}  // namespace touchstone
