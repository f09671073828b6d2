#pragma once

#include <string_view>

namespace touchstone {

/** The style sheet and the script of the page: page.css and page.js, built in. */
extern const std::string_view kPageCss;
extern const std::string_view kPageJs;

}  // namespace touchstone
