#include "scenarios/schema/scenario_schema.h"

#include <limits>
#include <vector>

#include <nlohmann/json.hpp>

#include "scenarios/schema/scenario_keys.h"

namespace touchstone {
namespace {

// Ordered, so that the committed copy reads like the table of keys and diffs are small.
using Json = nlohmann::ordered_json;

Json Number() {
  return {{"type", "number"}};
}
Json Length() {
  return {{"type", "number"}, {"exclusiveMinimum", 0}};
}
Json Text() {
  return {{"type", "string"}, {"minLength", 1}};
}

Json ListOf(const Json& element, int least, int most) {
  return {{"type", "array"}, {"items", element}, {"minItems", least}, {"maxItems", most}};
}

Json ListOf(const Json& element, int least) {
  return {{"type", "array"}, {"items", element}, {"minItems", least}};
}

Json TableOf(const std::vector<Key>& keys);

Json TableOf(TableKind kind) {
  return TableOf(std::vector<Key>(KeysOf(kind).begin(), KeysOf(kind).end()));
}

Json BodyOf(ShapeKind kind) {
  std::vector<Key> keys(BodyKeys().begin(), BodyKeys().end());
  keys.insert(keys.end(), ShapeKeys(kind).begin(), ShapeKeys(kind).end());
  Json body = TableOf(keys);
  body["title"] = NameOf(kind);
  body["properties"]["shape"]["const"] = NameOf(kind);
  body["not"] = {{"required", {"quaternion", "rotation"}}};
  return body;
}

Json Bodies() {
  Json shapes = Json::array();
  for (int kind = 0; kind < kShapeKinds; ++kind) {
    shapes.push_back(BodyOf(static_cast<ShapeKind>(kind)));
  }
  return {{"type", "object"},
          {"propertyNames", {{"pattern", "^[A-Za-z0-9_-]+$"}}},
          {"minProperties", 2},
          {"maxProperties", 2},
          {"additionalProperties", {{"oneOf", shapes}}}};
}

Json ValueOf(const Key& key) {
  switch (key.type) {
    case ValueType::kText:
      return Text();
    case ValueType::kId:
      return {{"type", "string"}, {"pattern", "^[a-z0-9_]+(/[a-z0-9_]+)*$"}};
    case ValueType::kBodyName:
      return Text();
    case ValueType::kShape:
      return {{"type", "string"}};
    case ValueType::kBool:
      return {{"type", "boolean"}};
    case ValueType::kCount:
      return {{"type", "integer"},
              {"minimum", 0},
              {"maximum", std::numeric_limits<int>::max()}};
    case ValueType::kNumber:
      return Number();
    case ValueType::kLength:
      return Length();
    case ValueType::kPoint:
      return ListOf(Number(), 3, 3);
    case ValueType::kLengths:
      return ListOf(Length(), 3, 3);
    case ValueType::kPoints:
      return ListOf(ListOf(Number(), 3, 3), 1);
    case ValueType::kUnitVectors:
      return ListOf(ListOf(Number(), 3, 3), 0);
    case ValueType::kQuaternion:
      return ListOf(Number(), 4, 4);
    case ValueType::kRotation:
      return ListOf(ListOf(Number(), 3, 3), 3, 3);
    case ValueType::kTable:
      return TableOf(key.table);
    case ValueType::kBodies:
      return Bodies();
    case ValueType::kTables:
      return ListOf(TableOf(key.table), 0);
  }
  return {};
}

Json TableOf(const std::vector<Key>& keys) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const Key& key : keys) {
    Json value = ValueOf(key);
    value["description"] = key.documentation;
    properties[std::string(key.name)] = std::move(value);
    if (key.required) required.push_back(key.name);
  }
  return {{"type", "object"},
          {"properties", properties},
          {"required", required},
          {"additionalProperties", false}};
}

}  // namespace

std::string ScenarioSchema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Touchstone scenario"}};
  schema.update(TableOf(TableKind::kFile));
  return schema.dump(2) + '\n';
}

}  // namespace touchstone
