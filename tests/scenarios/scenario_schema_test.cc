#include "scenarios/schema/scenario_schema.h"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scenarios/schema/scenario_keys.h"

namespace touchstone {
namespace {

std::string ContentsOf(const std::string& path) {
  std::ostringstream contents;
  contents << std::ifstream(path, std::ios::binary).rdbuf();
  return contents.str();
}

TEST(ScenarioSchema, IsTheCommittedOne) {
  const std::string committed = TOUCHSTONE_SOURCE_DIR "/docs/scenario.schema.json";
  const std::string generated = TOUCHSTONE_BINARY_DIR "/scenario.schema.json";
  std::ofstream(generated, std::ios::binary) << ScenarioSchema();
  // Compared as a bool: a page of JSON twice over would bury what to do.
  EXPECT_TRUE(ContentsOf(committed) == ScenarioSchema())
      << "The keys of scenario files changed. Run: cp " << generated << " " << committed;
}

TEST(ScenarioSchema, DocumentsEveryKeyThatTheReaderKnows) {
  const nlohmann::json schema = nlohmann::json::parse(ScenarioSchema());
  for (const Key& key : KeysOf(TableKind::kFile)) {
    EXPECT_EQ(schema.at("properties").at(std::string(key.name)).at("description"),
              key.documentation);
  }
  const nlohmann::json& bodies =
      schema.at("properties").at("bodies").at("additionalProperties").at("oneOf");
  ASSERT_EQ(bodies.size(), static_cast<std::size_t>(kShapeKinds));
  for (int i = 0; i < kShapeKinds; ++i) {
    const auto kind = static_cast<ShapeKind>(i);
    const nlohmann::json& body = bodies.at(static_cast<std::size_t>(i));
    EXPECT_EQ(body.at("properties").at("shape").at("const"), NameOf(kind));
    EXPECT_EQ(body.at("properties").size(), BodyKeys().size() + ShapeKeys(kind).size());
    EXPECT_EQ(body.at("additionalProperties"), false);
  }
}

TEST(ScenarioSchema, AsksForEveryRequiredKey) {
  const nlohmann::json schema = nlohmann::json::parse(ScenarioSchema());
  EXPECT_EQ(schema.at("required"),
            nlohmann::json({"id", "title", "source", "bodies", "contact"}));
}

TEST(ScenarioKeys, ExpectAnyOfTheShapesThereAre) {
  for (int i = 0; i < kShapeKinds; ++i) {
    EXPECT_NE(ExpectationOf(ValueType::kShape).find(NameOf(static_cast<ShapeKind>(i))),
              std::string_view::npos);
  }
}

}  // namespace
}  // namespace touchstone
