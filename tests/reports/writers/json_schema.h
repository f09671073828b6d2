#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace touchstone {

/** Returns where `value` breaks `schema`, as "path: what". Knows the part of JSON Schema
 that docs/report.schema.json uses: type, const, enum, anyOf, $ref to #/$defs, required,
 properties, additionalProperties, items, minItems, maxItems, minimum. A keyword beyond
 these is a fault of the schema and reported too. */
std::vector<std::string> SchemaFaults(const nlohmann::json& schema,
                                      const nlohmann::json& value);

}  // namespace touchstone
