#pragma once

#include <functional>
#include <map>
#include <string>

namespace touchstone {

/** Time by the clock on the wall, by the name of what it was spent on. [s] */
using SecondsByName = std::map<std::string, double, std::less<>>;

/** The time that one world took with one oracle. No judgement depends on it. [s] */
struct WorldSeconds {
  /** All of it: motions, judgement, and the processes between them. */
  double all = 0;
  /** Of the oracle, by kind of motion: "itself", "half step", "quarter step", "moved
   start", "again" (for `deterministic`), "ensemble", and the names of the variants. With
   "as shipped", all of CompareWithShipped(), which judges, too. */
  SecondsByName motions = {};
  /** Of the judgement of the oracle's motions, by law. */
  SecondsByName laws = {};
};

}  // namespace touchstone
