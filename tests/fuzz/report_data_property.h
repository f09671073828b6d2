#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/** Reads `bytes` as report data, and as the inflated contents of report data, and returns
 a fault of the reader; empty if there is none. The reader must either refuse the bytes
 with one diagnostic, or return findings that keep to the file and can be compared. */
std::string FaultOfReadingReportData(std::string_view bytes);

}  // namespace touchstone
