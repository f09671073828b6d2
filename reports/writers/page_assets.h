#pragma once

#include <string_view>

namespace touchstone {

/** Contents of reports/viewer/dist/viewer.html: the page of a report without data. */
extern const std::string_view kViewerHtml;

}  // namespace touchstone
