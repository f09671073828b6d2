#pragma once

#include "reports/clusters/clusters.h"
#include "reports/run_report.h"
#include "reports/writers/data/json_values.h"
#include "reports/writers/data/texts.h"
#include "reports/writers/data/world_data.h"

namespace touchstone {

/** Returns all findings in columns, `Findings` of docs/report_data.md. Values and
 tolerances have five digits, shares three. `moments`: those that curves tell. */
DataJson FindingsData(const RunReport& report, const Clusters& clusters,
                      const std::vector<Moment>& moments, Texts& texts);

/** Returns the names that the columns refer to by index. */
DataJson NamesData();

}  // namespace touchstone
