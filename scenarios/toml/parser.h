#pragma once

// toml++ 3.3 asserts what a file may well get wrong (a line break after the '[' of a
// table) before it checks the same and reports it. The check suffices; an abort would not
// do.
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>
