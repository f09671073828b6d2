#pragma once

#include <stdexcept>

namespace touchstone {

/** What the user gave cannot be used; what() says what is wrong and what would be right.
 Ends the program with exit code 2. */
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace touchstone
