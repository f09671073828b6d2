#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Returns `text` fit for XML and HTML content and quoted attributes: markup escaped,
 control characters that XML forbids replaced by U+FFFD. */
std::string XmlText(std::string_view text);

}  // namespace touchstone
