#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/run.h"

namespace touchstone {

/** Returns docs/accuracy.md: the worst error of each oracle on each pair of shapes, as
 measured by `report`, each kProposedBound times what was seen and rounded up to two
 digits. Errors are relative to SceneSize(). A pair that an oracle does not support is a
 row that says so. Then the same of worlds (world_accuracy.h). */
std::string AccuracyTable(const RunReport& report);

/** Returns what is wrong with the published table `text`, one sentence each, by the
 measured errors of `report`: an error above its row, an error below kImproved of its row
 (improved: a later regression would go unseen), a pair without a row, a row that cannot
 be read. Rows of oracles and pairs that the report does not have are not checked. Then
 the same of worlds. */
std::vector<std::string> CheckAccuracy(const RunReport& report, std::string_view text);

}  // namespace touchstone
