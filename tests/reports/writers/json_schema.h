#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace touchstone {

/** Returns the violations of `schema` by `value`, as "path: fault". Supports the part of
 JSON Schema that docs/report.schema.json and docs/scenario.schema.json use. Any other
 keyword is reported as a fault of the schema. */
std::vector<std::string> SchemaFaults(const nlohmann::json& schema,
                                      const nlohmann::json& value);

}  // namespace touchstone
