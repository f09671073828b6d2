#pragma once

#include <string>
#include <vector>

#include "oracles/oracle_registry.h"

namespace touchstone {

/** The options that choose the settings of engines in worlds. */
struct SetupArguments {
  bool as_shipped = false;       ///< All engines start from their shipped settings.
  std::vector<std::string> set;  ///< "ORACLE:NAME=VALUE", e.g. "ode:contact_erp=0.2".
};

/** Sets up the worlds of the oracles of `registry`. Throws InputError for an unknown
 oracle or parameter, with the nearest name, and for a value that is no number or out of
 the range of its parameter. */
void ChooseSetups(const SetupArguments& arguments, OracleRegistry& registry);

}  // namespace touchstone
