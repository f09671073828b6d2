#pragma once

#include <compare>
#include <map>
#include <string>
#include <vector>

#include "reports/sweep/sweep_file.h"
#include "reports/triage/rate.h"

namespace touchstone {

/** The failed answers of one oracle that look alike: they have one decisive measure and
 one ending, and belong to one pair of shapes in either order, or one family of worlds. */
struct Symptom {
  /** The properties that its answers share. */
  struct Key {
    std::string oracle;
    std::string of;  ///< "box, sphere" or a family of worlds.
    MeasureKind measure;
    Verdict verdict;
    std::string law;     ///< Same as Finding::law.
    std::string ending;  ///< EndingOf() the finding.

    auto operator<=>(const Key&) const = default;
  };
  Key key;
  FailedQuestion gravest;  ///< The gravest of those that the sweep has kept.
  /** How often it was found, by what was asked: "random, sphere and box". */
  std::map<std::string, Rate> rates;
};

/** Returns the symptoms of a sweep, the gravest first: missing answers, then by band and
 by share. Throws SweepFileError. */
std::vector<Symptom> SymptomsOf(const SweepFile& file);

}  // namespace touchstone
