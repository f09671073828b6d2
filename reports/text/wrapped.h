#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchstone {

/** Returns `text` broken at spaces, so that no line is longer than `width` characters
 unless a word is. Every line but the first starts with `indent` spaces. A width of 0
 breaks nothing. Characters are code points of UTF-8. */
std::string Wrapped(std::string_view text, std::size_t width, std::size_t indent);

}  // namespace touchstone
