#pragma once

#include <string_view>
#include <vector>

#include "oracles/contact_answer.h"
#include "reports/contacts/contact_result.h"
#include "reports/writers/data/json_values.h"

namespace touchstone {

/** Returns a shape as `Shape` of docs/report_data.md. */
DataJson ShapeData(const Shape& shape);

/** Returns a contact question with its truth and its answers, as `Contact`. `asked[o]`:
 whether oracle o answers contact queries at all. Numbers round trip. */
DataJson ContactData(const ScenarioResult& result, const std::vector<bool>& asked);

/** Returns "answered", "unsupported", "crashed" or "timed out". */
std::string_view NameOf(AnswerStatus status);

}  // namespace touchstone
