#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "scenarios/diagnostic.h"

namespace touchstone {

/** Where the words of a scenario stand in its file: for errors that show only when what
 it says is understood. */
struct FilePlaces {
  struct Place {
    int line = 0;
    int column = 0;
  };
  /** Of a key, and of its value; the same for an element of a list. */
  struct KeyAndValue {
    Place key;
    Place value;
  };

  std::string file;  ///< As diagnostics call it; empty: the scenario has no file.
  /** By path, e.g. "claims[0].numbers.expected_time". What is not an expectation, a claim
   or an indictment is left out. */
  std::map<std::string, KeyAndValue, std::less<>> by_path;
};

/** Returns the error of the value of `path`, or of what it is in where it is not there.
 */
Diagnostic ErrorAtValue(const FilePlaces& places, std::string_view path, std::string what,
                        std::string expected);

/** Returns the same, shown where the key stands. */
Diagnostic ErrorAtKey(const FilePlaces& places, std::string_view path, std::string what,
                      std::string expected);

}  // namespace touchstone
