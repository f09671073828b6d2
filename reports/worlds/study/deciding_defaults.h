#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"

namespace touchstone {

/** Finds the settings of an oracle on which a verdict depends: those whose default, in
 place of the value in force, changes it. */
class DecidingDefaults {
 public:
  /** Returns the findings of an oracle that is set up otherwise. */
  using Judge = std::function<std::vector<Finding>(const Oracle&)>;
  /** Returns whether findings have the verdict that the oracle has as shipped. */
  using IsAsShipped = std::function<bool(const std::vector<Finding>&)>;

  /** `oracle` must outlive this object. */
  DecidingDefaults(const Oracle& oracle, Judge judge);

  /** Returns whether every setting has its default. */
  bool empty() const { return differences_.empty(); }

  /** Returns the settings that decide, as the end of a sentence: each one whose default
   changes the verdict alone. If there is none and `together` is true, all settings get
   their defaults, and one after the other goes back to its value if the verdict stays
   changed; those that still have their defaults are returned. Each setup is asked once,
   also for several verdicts. */
  std::string Name(const IsAsShipped& is_as_shipped, bool together);

 private:
  /** A parameter in force with another value than the engine's default. */
  struct Difference {
    const WorldParameter* parameter;
    double value;  ///< The value in force.
  };
  /** Whether each difference is replaced by its default. */
  using Choice = std::vector<bool>;

  const std::vector<Finding>& FindingsWith(const Choice& defaults);
  std::string InWords(const Choice& defaults) const;

  const Oracle& oracle_;
  Judge judge_;
  std::vector<Difference> differences_;
  std::map<Choice, std::vector<Finding>> asked_;
};

}  // namespace touchstone
