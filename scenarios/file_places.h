#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "scenarios/diagnostic.h"

namespace touchstone {

/** The positions of a scenario's keys and values in its file, for errors that are found
 only after the file has been read. */
struct FilePlaces {
  struct Place {
    int line = 0;
    int column = 0;
  };
  /** The positions of a key and of its value; the two are equal for a list element. */
  struct KeyAndValue {
    Place key;
    Place value;
  };

  std::string file;  ///< File name used in diagnostics; empty: the scenario has no file.
  /** Indexed by path, e.g. "claims[0].numbers.expected_time". Only expectations, claims
   and indictments are recorded. */
  std::map<std::string, KeyAndValue, std::less<>> by_path;
};

/** Returns an error positioned at the value of `path`, or at its nearest recorded parent
 if the path itself is not recorded. */
Diagnostic ErrorAtValue(const FilePlaces& places, std::string_view path, std::string what,
                        std::string expected);

/** Returns the same error positioned at the key. */
Diagnostic ErrorAtKey(const FilePlaces& places, std::string_view path, std::string what,
                      std::string expected);

}  // namespace touchstone
