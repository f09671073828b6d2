#include "scenarios/schema/scenario_schema.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scenarios/measure_kind.h"
#include "scenarios/schema/scenario_keys.h"

namespace touchstone {
namespace {

// Ordered, so that the committed copy follows the table of keys and diffs stay small.
using Json = nlohmann::ordered_json;

Json Number() {
  return {{"type", "number"}};
}
Json Positive() {
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

Json OneOfTheKeys(const char* a, const char* b) {
  return {{{"required", {a}}}, {{"required", {b}}}};
}

Json TableOf(TableKind kind) {
  Json table = TableOf(std::vector<Key>(KeysOf(kind).begin(), KeysOf(kind).end()));
  if (kind == TableKind::kWorld) table["oneOf"] = OneOfTheKeys("steps", "duration");
  return table;
}

Json BodyOf(ShapeKind kind, bool may_move) {
  std::vector<Key> keys(BodyKeys().begin(), BodyKeys().end());
  keys.insert(keys.end(), ShapeKeys(kind).begin(), ShapeKeys(kind).end());
  if (may_move) keys.insert(keys.end(), MotionKeys().begin(), MotionKeys().end());
  Json body = TableOf(keys);
  body["title"] = NameOf(kind);
  body["properties"]["shape"]["const"] = NameOf(kind);
  body["not"] = {{"required", {"quaternion", "rotation"}}};
  return body;
}

/** Returns a schema that applies `then` where the condition holds. */
Json If(const Json& condition, const Json& then) {
  return {{"if", condition}, {"then", then}};
}

/** Returns the schema of a table of named tables, each with the schema `value`. */
Json NamedTables(const Json& value) {
  return {{"type", "object"},
          {"propertyNames", {{"pattern", "^[A-Za-z0-9_-]+$"}}},
          {"additionalProperties", value}};
}

Json Bodies(bool may_move) {
  Json names = Json::array();
  Json choices = Json::array();
  for (int i = 0; i < kShapeKinds; ++i) {
    const auto kind = static_cast<ShapeKind>(i);
    names.push_back(NameOf(kind));
    choices.push_back(If(
        {{"properties", {{"shape", {{"const", NameOf(kind)}}}}}, {"required", {"shape"}}},
        BodyOf(kind, may_move)));
  }
  return NamedTables({{"type", "object"},
                      {"properties", {{"shape", {{"enum", names}}}}},
                      {"required", {"shape"}},
                      {"allOf", choices}});
}

Json Two(Json bodies) {
  bodies["minProperties"] = 2;
  bodies["maxProperties"] = 2;
  return bodies;
}

Json Integer(int least) {
  return {{"type", "integer"},
          {"minimum", least},
          {"maximum", std::numeric_limits<int>::max()}};
}

Json NotNegative() {
  return {{"type", "number"}, {"minimum", 0}};
}

Json Measures() {
  Json names = Json::array();
  for (const MeasureKind measure : AllMeasures()) names.push_back(NameOf(measure));
  return ListOf({{"type", "string"}, {"enum", names}}, 1);
}

Json ValueOf(const Key& key) {
  switch (key.type) {
    case ValueType::kText:
      return Text();
    case ValueType::kMeasures:
      return Measures();
    case ValueType::kId:
      return {{"type", "string"}, {"pattern", "^[a-z0-9_]+(/[a-z0-9_]+)*$"}};
    case ValueType::kWord:
      return {{"type", "string"}, {"pattern", "^[a-z0-9_]+$"}};
    case ValueType::kBodyName:
      return Text();
    case ValueType::kNames:
      return ListOf(Text(), 0);
    case ValueType::kShape:
      return {{"type", "string"}};
    case ValueType::kBool:
      return {{"type", "boolean"}};
    case ValueType::kCount:
      return Integer(0);
    case ValueType::kPositiveCount:
      return Integer(1);
    case ValueType::kSeed:
      return {{"type", "integer"},
              {"minimum", 0},
              {"maximum", std::numeric_limits<std::uint32_t>::max()}};
    case ValueType::kNumber:
      return Number();
    case ValueType::kNotNegative:
      return NotNegative();
    case ValueType::kPositive:
    case ValueType::kLength:
      return Positive();
    case ValueType::kShare:
      return {{"type", "number"}, {"minimum", 0}, {"maximum", 1}};
    case ValueType::kPoint:
      return ListOf(Number(), 3, 3);
    case ValueType::kLengths:
    case ValueType::kMoments:
      return ListOf(Positive(), 3, 3);
    case ValueType::kPoints:
      return ListOf(ListOf(Number(), 3, 3), 1);
    case ValueType::kUnitVectors:
      return ListOf(ListOf(Number(), 3, 3), 0);
    case ValueType::kQuaternion:
      return ListOf(Number(), 4, 4);
    case ValueType::kRotation:
      return ListOf(ListOf(Number(), 3, 3), 3, 3);
    case ValueType::kNodes:
      return ListOf(ListOf(Integer(0), 2, 2), 0);
    case ValueType::kAnchor:
      return {{"anyOf", {Text(), ListOf(Number(), 3, 3), TableOf(TableKind::kAnchor)}}};
    case ValueType::kNumbers:
      return {{"type", "object"},
              {"propertyNames", {{"pattern", "^[a-z0-9_]+$"}}},
              {"additionalProperties", Number()}};
    case ValueType::kTable:
      return TableOf(key.table);
    case ValueType::kBodies:
      return Two(Bodies(false));
    case ValueType::kMovingBodies:
      return Bodies(true);
    case ValueType::kNamedTables:
      return NamedTables(TableOf(key.table));
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

/** Restricts the name of a law to `claims`. "enumDescriptions" and "x-taplo" are what
 editors for JSON and for TOML show next to each name. */
void NameLaws(std::span<const ClaimName> claims, Json& law) {
  law.erase("pattern");
  Json descriptions = Json::array();
  for (const ClaimName& claim : claims) {
    law["enum"].push_back(claim.name);
    descriptions.push_back(claim.documentation);
  }
  law["enumDescriptions"] = descriptions;
  law["x-taplo"] = {{"docs", {{"enumValues", descriptions}}}};
}

}  // namespace

std::string ScenarioSchema(std::span<const ClaimName> claims) {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Touchstone scenario"},
                 {"type", "object"}};
  Json contact = TableOf(TableKind::kContactFile);
  contact["title"] = "contact query";
  Json world = TableOf(TableKind::kWorldFile);
  world["title"] = "world";
  NameLaws(claims, world["properties"]["claims"]["items"]["properties"]["law"]);
  // The reader tells them apart in the same way (scenarios/read_scenario.cc).
  Json of_worlds = Json::array({{{"required", {"world"}}}});
  Json any = Json::array();
  for (const std::string_view key : KeysOfWorldsOnly())
    any.push_back({{"required", {key}}});
  of_worlds.push_back({{"not", {{"required", {"contact"}}}}, {"anyOf", any}});
  schema["if"] = {{"anyOf", of_worlds}};
  schema["then"] = world;
  schema["else"] = contact;
  return schema.dump(2) + '\n';
}

}  // namespace touchstone
