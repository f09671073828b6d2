#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** An oracle that this build cannot offer. */
struct MissingOracle {
  std::string name;
  std::string how_to_get;  ///< E.g. "ODE was not found: apt-get install libode-dev, rebuild".
};

/** The oracles that can be asked, by name, in the order they were added. */
class OracleRegistry {
 public:
  /** Returns every oracle that this build has, and records those that it lacks. The specimens
   of the printed engine ("printed", "printed:E-04", "printed:none") are made on demand by
   Find(), only "printed" is listed. */
  static OracleRegistry BuiltIn();

  /** Adds a user's oracle. Replaces nothing: throws std::invalid_argument if the name exists. */
  void Add(std::unique_ptr<Oracle> oracle);

  /** Returns the oracle of that exact name, or null. */
  const Oracle* Find(std::string_view name) const;

  /** Returns the oracles named `pattern` or below it: "fcl" gives all "fcl/…". Empty if none. */
  std::vector<const Oracle*> Matching(std::string_view pattern) const;

  std::vector<const Oracle*> All() const;
  const std::vector<MissingOracle>& missing() const { return missing_; }

 private:
  std::vector<std::unique_ptr<Oracle>> oracles_;
  std::vector<MissingOracle> missing_;
};

}  // namespace touchstone
