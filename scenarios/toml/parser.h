#pragma once

// toml++ 3.3 asserts a condition that a faulty file can violate (no line break after the
// '[' of a table), and then checks and reports the same condition. The check suffices;
// the assertion would abort the program.
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>
