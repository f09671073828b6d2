#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/run_report.h"

namespace touchstone {

/** Returns the text of docs/accuracy.md: the worst error of each oracle on each pair of
 shapes, then the same for worlds (world_accuracy.h). Each published value is
 kProposedBound times the measured one, rounded up to two digits. Errors are relative to
 SceneSize(). A pair that an oracle does not support has a row that says so. */
std::string AccuracyTable(const RunReport& report);

/** Compares the published table `text` with the errors measured in `report` and returns
 the faults, one sentence each. A fault is an error above its row, an error below
 kImproved of its row (improved: a later regression would go unseen), a pair without a
 row, or an unreadable row. Rows of oracles and pairs that `report` does not contain are
 not checked. The table of worlds is checked alike. */
std::vector<std::string> CheckAccuracy(const RunReport& report, std::string_view text);

}  // namespace touchstone
