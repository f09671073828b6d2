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
    std::string law;        ///< Same as Finding::law.
    std::string ending;     ///< EndingOf() the finding.
    bool touching = false;  ///< Same as FindingKind::touching.

    auto operator<=>(const Key&) const = default;
  };
  Key key;
  /** The four gravest of those that the sweep has kept, the gravest first. */
  std::vector<FailedQuestion> kept;
  /** How often it was found, by what was asked: "random, sphere and box" or
   "the file poses.csv, sphere and box". */
  std::map<std::string, Rate> rates;
};

/** Returns the symptoms of a sweep, the gravest first: missing answers, then by band and
 by share. Answers that merely differ from those of other oracles are left out: alone they
 are no fault. Throws SweepFileError, also if a kept question cannot be read. */
std::vector<Symptom> SymptomsOf(const SweepFile& file);

}  // namespace touchstone
