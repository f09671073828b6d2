#include "reports/writers/html_writer.h"

#include "reports/writers/data/base64.h"
#include "reports/writers/page_assets.h"

namespace touchstone {
namespace {

/** The script element of the viewer that holds the data. */
constexpr std::string_view kOpening =
    "<script type=\"application/octet-stream\" id=\"report-data\">";

}  // namespace

void WritePage(std::string_view report_data, std::ostream& out) {
  // Base64 has no '<', so the data cannot end their element.
  const std::size_t at = kViewerHtml.find(kOpening) + kOpening.size();
  out << kViewerHtml.substr(0, at) << Base64(report_data) << kViewerHtml.substr(at);
}

void WriteHtml(const RunReport& report, const RunFacts& facts, std::ostream& out) {
  WritePage(ReportData(report, facts), out);
}

}  // namespace touchstone
