#pragma once

#include <string>
#include <vector>

#include "oracles/oracle_registry.h"

namespace touchstone {

/** The oracles that a command uses. */
struct OracleSelection {
  std::string subject;        ///< Name of one oracle.
  StatedTolerance tolerance;  ///< Replaces that of the subject, unless it is zero.
  std::vector<std::string>
      against;  ///< References, names or groups ("fcl"); empty: all others.
};

/** Returns the oracle of that exact name. Throws the same errors as SelectOracles(). */
const Oracle& OracleNamed(const OracleRegistry& registry, const std::string& name);

/** Returns the subject, then the references. If `selection` names no references, they are
 all other oracles in the order of the registry, except specimens of faults ("printed").
 Throws InputError for an unknown name, with the nearest name, or with instructions to
 install the oracle if this build lacks it. */
std::vector<const Oracle*> SelectOracles(const OracleRegistry& registry,
                                         const OracleSelection& selection);

/** A kind of question. */
enum class QuestionKind { kContact, kWorld };

/** Returns the oracles that `list` names, each once: names or groups, separated by
 commas, or "all" for every oracle that answers questions of that kind, except specimens
 of faults. Throws the same errors as SelectOracles(). */
std::vector<const Oracle*> SubjectsNamed(const OracleRegistry& registry,
                                         const std::string& list, QuestionKind kind);

/** Returns the oracles that `pattern` names. Throws the same errors as SelectOracles().
 */
std::vector<const Oracle*> OraclesNamed(const OracleRegistry& registry,
                                        const std::string& pattern);

}  // namespace touchstone
