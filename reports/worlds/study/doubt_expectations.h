#pragma once

#include <span>
#include <string>
#include <vector>

#include "oracles/oracle.h"
#include "reports/finding/finding.h"
#include "reports/worlds/study/world_result.h"

namespace touchstone {

/** Looks for expectations of a world that no engine meets, although engines of two
 libraries agree with each other to a tenth of the error that they are accused of. Not
 they are the suspects but the file: its findings become undecidable and accuse nobody.
 Returns one fault of the file for each such expectation.

 An engine that leaves the body alone where something may act on it is no evidence: it may
 have missed a contact. If only such engines agree, the findings become undecidable too,
 and the file has no fault.
 @param oracles those of `result`, in its order.
 @param findings all findings of this world. */
std::vector<std::string> DoubtExpectations(const WorldResult& result,
                                           std::span<const OracleInfo> oracles,
                                           std::span<Finding> findings);

}  // namespace touchstone
