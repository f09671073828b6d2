#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

class Oracle;

/** A number with which an adapter sets up the worlds of an engine, and which a user may
 choose. An adapter declares each of them once. */
struct WorldParameter {
  std::string name;  ///< E.g. "contact_erp".
  double here;       ///< The value of this adapter, in the unit that `what` states.
  double shipped;    ///< The default of the engine.
  double least;      ///< The least value that may be chosen.
  double most;       ///< The greatest value that may be chosen.
  bool whole;        ///< Whether only whole numbers may be chosen.
  std::string what;  ///< Meaning, unit and the engine's own name, one phrase.
  std::string why;   ///< The reason for `here`, one sentence; empty for the default.
};

/** The source of the values of the parameters of an oracle's worlds. */
struct WorldSetup {
  /** Whether the engine's defaults are the base, not the values of the adapter. */
  bool as_shipped = false;
  /** Values in place of those of the base, by name of the parameter. */
  std::map<std::string, double, std::less<>> chosen;

  bool IsDefault() const { return !as_shipped && chosen.empty(); }
};

/** Returns the values of `parameters` that are in force with `setup`, in their order. */
std::vector<double> ValuesOf(std::span<const WorldParameter> parameters,
                             const WorldSetup& setup);

/** Returns why `value` may not be chosen for `parameter`, as what is expected: "a whole
 number from 1 to 1000". Empty if it may. */
std::string Refusal(const WorldParameter& parameter, double value);

/** Returns the setup in words: "as shipped, with contact_erp = 0.2 (0 as set here, 0.2 as
 shipped)". Empty for the default setup. */
std::string ToString(const WorldSetup& setup, std::span<const WorldParameter> parameters);

/** Returns `oracle`, which must live longer, under the same name, with its worlds set up
 by `setup`. This is the default of Oracle::SetUp(). */
std::unique_ptr<Oracle> WithSetup(const Oracle& oracle, const WorldSetup& setup);

}  // namespace touchstone
