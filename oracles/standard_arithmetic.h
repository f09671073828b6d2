#pragma once

#include <cfenv>

namespace touchstone {

/** Floating-point arithmetic by IEEE 754 on this thread while the object lives: rounding
 to nearest, denormal numbers, no traps. Its destructor restores what was set before, even
 if an engine has changed it meanwhile.

 Every error bound of the referee assumes this arithmetic, and every engine is asked in
 it. An engine that sets another rounding mode or flushes denormals to zero thus changes
 its own answer only. A program linked with -ffast-math starts with denormals flushed. */
class StandardArithmetic {
 public:
  StandardArithmetic() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~StandardArithmetic() { std::fesetenv(&before_); }

  StandardArithmetic(const StandardArithmetic&) = delete;
  StandardArithmetic& operator=(const StandardArithmetic&) = delete;

 private:
  std::fenv_t before_;
};

}  // namespace touchstone
