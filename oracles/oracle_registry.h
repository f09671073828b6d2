#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/oracle.h"

namespace touchstone {

/** An oracle that cannot be offered here. */
struct MissingOracle {
  std::string name;
  /** E.g. "ODE was not found: apt-get install libode-dev, rebuild". */
  std::string how_to_get;
};

/** The available oracles, by name, in the order in which they were added; those of one
 library, such as its versions, stand together. */
class OracleRegistry {
 public:
  /** Returns every oracle that this build has, and records those that it lacks. Among the
   specimens of the printed engine only "printed" is listed; others, for example
   "printed:E-04" and "printed:none", are created on the first Find(). */
  static OracleRegistry BuiltIn();

  /** Adds a user's oracle, after the others of its library if there are any.
   @throws std::invalid_argument if the name exists already. */
  void Add(std::unique_ptr<Oracle> oracle);

  /** Records an oracle that cannot be offered, unless one of its name exists. */
  void AddMissing(MissingOracle missing);

  /** Replaces the stated tolerance of the oracle `name`, see WithTolerance(). Does
   nothing if there is no such oracle. Pointers to it that Find() returned stay valid, but
   keep the tolerance from before. */
  void SetTolerance(std::string_view name, const StatedTolerance& tolerance);

  /** Sets up the worlds of the oracle `name` by `setup` from now on, see Oracle::SetUp().
   Does nothing if there is no such oracle, or if it simulates no worlds. Pointers to it
   that Find() returned stay valid, but keep the setup from before. */
  void SetUp(std::string_view name, const WorldSetup& setup);

  /** Returns the oracle of that exact name, or null. It lives as long as the registry.
   Thread safe, like all const functions here. */
  const Oracle* Find(std::string_view name) const;

  /** Returns the oracles named `pattern` or below it: "fcl" returns all "fcl/…". */
  std::vector<const Oracle*> Matching(std::string_view pattern) const;

  /** Returns whether an oracle of that name exists, here or in a build that includes the
   engines missing from this one. */
  bool MayExist(std::string_view name) const;

  std::vector<const Oracle*> All() const;

  /** Returns the names of the specimens that Find() creates, without combinations of
   several errata. */
  std::vector<std::string> SpecimenNames() const;

  const std::vector<MissingOracle>& missing() const { return missing_; }

 private:
  /** The specimens that Find() has created. */
  struct Specimens {
    std::mutex mutex;
    std::map<std::string, std::unique_ptr<Oracle>, std::less<>> by_name;
  };

  const Oracle* FindSpecimen(std::string_view name) const;

  std::vector<std::unique_ptr<Oracle>> oracles_;
  /** Replaces the oracle `name` by `change(oracle)` and keeps it alive. */
  template <typename Change>
  void Replace(std::string_view name, Change change);

  /** The oracles that State() and SetUp() have replaced. */
  std::vector<std::unique_ptr<Oracle>> replaced_;
  std::unique_ptr<Specimens> specimens_;  // Null unless created by BuiltIn().
  std::vector<MissingOracle> missing_;
};

}  // namespace touchstone
