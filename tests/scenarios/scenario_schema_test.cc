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

TEST(ScenarioSchema, EqualsTheCommittedFile) {
  const std::string committed = TOUCHSTONE_SOURCE_DIR "/docs/scenario.schema.json";
  const std::string generated = TOUCHSTONE_BINARY_DIR "/scenario.schema.json";
  std::ofstream(generated, std::ios::binary) << ScenarioSchema();
  // Compared as a bool, since two pages of JSON would bury the instruction.
  EXPECT_TRUE(ContentsOf(committed) == ScenarioSchema())
      << "The keys of scenario files changed. Run: cp " << generated << " " << committed;
}

/** Returns the schema of files of `kind`. */
nlohmann::json SchemaOf(TableKind kind) {
  const nlohmann::json schema = nlohmann::json::parse(ScenarioSchema());
  return schema.at("oneOf").at(kind == TableKind::kContactFile ? 0 : 1);
}

TEST(ScenarioSchema, DocumentsEveryKeyThatTheReaderKnows) {
  for (const TableKind kind : {TableKind::kContactFile, TableKind::kWorldFile}) {
    const nlohmann::json schema = SchemaOf(kind);
    EXPECT_EQ(schema.at("properties").size(), KeysOf(kind).size());
    for (const Key& key : KeysOf(kind)) {
      EXPECT_EQ(schema.at("properties").at(std::string(key.name)).at("description"),
                key.documentation);
    }
  }
}

TEST(ScenarioSchema, GivesEveryShapeItsOwnKeys) {
  for (const TableKind file : {TableKind::kContactFile, TableKind::kWorldFile}) {
    const std::size_t of_motion = file == TableKind::kWorldFile ? MotionKeys().size() : 0;
    const nlohmann::json schema = SchemaOf(file);
    const nlohmann::json& bodies =
        schema.at("properties").at("bodies").at("additionalProperties").at("oneOf");
    ASSERT_EQ(bodies.size(), static_cast<std::size_t>(kShapeKinds));
    for (int i = 0; i < kShapeKinds; ++i) {
      const auto kind = static_cast<ShapeKind>(i);
      const nlohmann::json& body = bodies.at(static_cast<std::size_t>(i));
      EXPECT_EQ(body.at("properties").at("shape").at("const"), NameOf(kind));
      EXPECT_EQ(body.at("properties").size(),
                BodyKeys().size() + ShapeKeys(kind).size() + of_motion);
      EXPECT_EQ(body.at("additionalProperties"), false);
    }
  }
}

TEST(ScenarioSchema, RequiresEveryRequiredKey) {
  EXPECT_EQ(SchemaOf(TableKind::kContactFile).at("required"),
            nlohmann::json({"id", "title", "source", "bodies", "contact"}));
  EXPECT_EQ(SchemaOf(TableKind::kWorldFile).at("required"),
            nlohmann::json({"id", "title", "source", "world"}));
}

TEST(ScenarioKeys, ListEveryShape) {
  for (int i = 0; i < kShapeKinds; ++i) {
    EXPECT_NE(ExpectationOf(ValueType::kShape).find(NameOf(static_cast<ShapeKind>(i))),
              std::string_view::npos);
  }
}

}  // namespace
}  // namespace touchstone
