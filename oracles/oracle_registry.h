#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** An oracle that this build cannot offer. */
struct MissingOracle {
  std::string name;
  std::string
      how_to_get;  ///< E.g. "ODE was not found: apt-get install libode-dev, rebuild".
};

/** The oracles that can be asked, by name, in the order they were added. */
class OracleRegistry {
 public:
  /** Returns every oracle that this build has, and records those that it lacks. Of the
   specimens of the printed engine only "printed" is listed; "printed:E-04",
   "printed:none" and the like are made when first asked for. */
  static OracleRegistry BuiltIn();

  /** Adds a user's oracle. Replaces nothing: throws std::invalid_argument if the name
   * exists. */
  void Add(std::unique_ptr<Oracle> oracle);

  /** Returns the oracle of that exact name, or null. It lives as long as the registry.
   Thread safe, as all const functions here. */
  const Oracle* Find(std::string_view name) const;

  /** Returns the oracles named `pattern` or below it: "fcl" gives all "fcl/…". Empty if
   none. */
  std::vector<const Oracle*> Matching(std::string_view pattern) const;

  /** Returns whether there is an oracle of that name, here or in a build that has what
   this one is missing. */
  bool MayExist(std::string_view name) const;

  std::vector<const Oracle*> All() const;

  /** Returns the names of specimens that Find() makes; those of several errata are left
   out. */
  std::vector<std::string> SpecimenNames() const;

  const std::vector<MissingOracle>& missing() const { return missing_; }

 private:
  /** What Find() made. */
  struct Specimens {
    std::mutex mutex;
    std::map<std::string, std::unique_ptr<Oracle>, std::less<>> by_name;
  };

  const Oracle* FindSpecimen(std::string_view name) const;

  std::vector<std::unique_ptr<Oracle>> oracles_;
  std::unique_ptr<Specimens> specimens_;  // Null but in BuiltIn().
  std::vector<MissingOracle> missing_;
};

}  // namespace touchstone
