#pragma once

#include <string_view>

namespace touchstone {

/** Contents of page.css and page.js, the style sheet and the script of the page. */
extern const std::string_view kPageCss;
extern const std::string_view kPageJs;

}  // namespace touchstone
