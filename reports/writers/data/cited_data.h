#pragma once

#include "reports/clusters/clusters.h"
#include "reports/run_report.h"
#include "reports/writers/data/json_values.h"

namespace touchstone {

/** Returns what the proofs of worlds name, in columns of one length, for the findings
 whose proofs name any body or position: "finding", the index of the finding, rising;
 "bodies", indices into the bodies of its world; "points", in the world frame [m]. */
DataJson CitedData(const RunReport& report, const Clusters& clusters);

}  // namespace touchstone
