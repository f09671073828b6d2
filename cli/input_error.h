#pragma once

#include <stdexcept>

namespace touchstone {

/** An error in the user's input. The text of what() states the fault and the expected
 input. Ends the program with exit code 2. */
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace touchstone
