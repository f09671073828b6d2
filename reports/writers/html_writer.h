#pragma once

#include <ostream>
#include <string_view>

#include "reports/run_report.h"
#include "reports/writers/report_data.h"

namespace touchstone {

/** Writes `report` as a page that needs no other file: the viewer of reports/viewer/ with
 the data of the report in it. The same report gives the same bytes. */
void WriteHtml(const RunReport& report, const RunFacts& facts, std::ostream& out);

/** Writes the page of `report_data`, what ReportData() has returned. */
void WritePage(std::string_view report_data, std::ostream& out);

}  // namespace touchstone
