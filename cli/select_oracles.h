#pragma once

#include <string>
#include <vector>

#include "oracles/oracle_registry.h"

namespace touchstone {

/** Which oracles a command asks. */
struct OracleSelection {
  std::string subject;  ///< One oracle, by its name.
  std::vector<std::string>
      against;  ///< Names, or what names begin with; empty: all others.
};

/** Returns the subject, then the references in the order of the registry, without the
 subject. Specimens of faults ("printed") are references only where they are named. Throws
 InputError with the nearest name and what is missing in this build where a name is
 unknown. */
std::vector<const Oracle*> SelectOracles(const OracleRegistry& registry,
                                         const OracleSelection& selection);

/** Returns the oracles that `pattern` names; throws as SelectOracles(). */
std::vector<const Oracle*> OraclesNamed(const OracleRegistry& registry,
                                        const std::string& pattern);

}  // namespace touchstone
