#include "scenarios/schema/scenario_schema.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <toml++/toml.h>

#include "reports/worlds/study/check_claims.h"
#include "scenarios/schema/scenario_keys.h"
#include "tests/reports/writers/json_schema.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

std::string ContentsOf(const std::filesystem::path& path) {
  std::ostringstream contents;
  contents << std::ifstream(path, std::ios::binary).rdbuf();
  return contents.str();
}

TEST(ScenarioSchema, EqualsTheCommittedFile) {
  const auto committed = InSourceTree("docs/scenario.schema.json");
  const auto generated =
      std::filesystem::path(testing::TempDir()) / "scenario.schema.json";
  std::ofstream(generated, std::ios::binary) << ScenarioSchema(ClaimNames());
  // Compared as a bool, since two pages of JSON would bury the instruction.
  EXPECT_TRUE(ContentsOf(committed) == ScenarioSchema(ClaimNames()))
      << "The keys of scenario files changed. Run: cp " << generated << " " << committed;
}

nlohmann::json Schema() {
  return nlohmann::json::parse(ScenarioSchema(ClaimNames()));
}

/** Returns the schema of files of `kind`. */
nlohmann::json SchemaOf(TableKind kind) {
  return Schema().at(kind == TableKind::kContactFile ? "else" : "then");
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
        schema.at("properties").at("bodies").at("additionalProperties").at("allOf");
    ASSERT_EQ(bodies.size(), static_cast<std::size_t>(kShapeKinds));
    for (int i = 0; i < kShapeKinds; ++i) {
      const auto kind = static_cast<ShapeKind>(i);
      const nlohmann::json& body = bodies.at(static_cast<std::size_t>(i)).at("then");
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

nlohmann::json ToJson(const toml::node& node) {
  if (const toml::table* table = node.as_table()) {
    nlohmann::json json = nlohmann::json::object();
    for (const auto& [key, value] : *table) json[std::string(key.str())] = ToJson(value);
    return json;
  }
  if (const toml::array* array = node.as_array()) {
    nlohmann::json json = nlohmann::json::array();
    for (const toml::node& element : *array) json.push_back(ToJson(element));
    return json;
  }
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* integer = node.as_integer()) return integer->get();
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* truth = node.as_boolean()) return truth->get();
  return {};
}

std::vector<std::string> FaultsOfText(std::string_view text) {
  return SchemaFaults(Schema(), ToJson(toml::parse(text)));
}

TEST(ScenarioSchema, AcceptsTheWholeCatalogue) {
  const nlohmann::json schema = Schema();
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           InSourceTree("scenarios/catalogue"))) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    EXPECT_THAT(SchemaFaults(schema, ToJson(toml::parse_file(entry.path().string()))),
                ElementsAre())
        << entry.path();
  }
  EXPECT_GT(files, 600);
}

constexpr std::string_view kWorld = R"(id = "mine/world"
title = "A ball"
source = "None."
[world]
dt = 0.001
steps = 10
[bodies.ball]
shape = "sphere"
radius = 1
velocity = [0, 0, 1]
[[claims]]
law = "ballistic"
)";

std::string With(std::string_view from, std::string_view to) {
  std::string text(kWorld);
  return text.replace(text.find(from), from.size(), to);
}

// An editor underlines the place of each fault, so there must be one, at the wrong key.
TEST(ScenarioSchema, FindsAWrongKeyWhereItIs) {
  EXPECT_THAT(FaultsOfText(kWorld), ElementsAre());
  EXPECT_THAT(FaultsOfText(With("velocity", "velocty")),
              ElementsAre("/bodies/ball: unknown property velocty"));
  EXPECT_THAT(FaultsOfText(With("radius = 1", "radius = -1")),
              ElementsAre("/bodies/ball/radius: exclusiveMinimum"));
  EXPECT_THAT(FaultsOfText(With("sphere", "ball")),
              ElementsAre("/bodies/ball/shape: not one of the allowed values"));
  EXPECT_THAT(FaultsOfText(With("dt = 0.001", "dt = \"fast\"")),
              ElementsAre("/world/dt: type, expected \"number\""));
  EXPECT_THAT(FaultsOfText(With("title", "titel")),
              UnorderedElementsAre(": lacks \"title\"", ": unknown property titel"));
}

TEST(ScenarioSchema, KnowsTheNamesOfTheLaws) {
  EXPECT_THAT(FaultsOfText(With("\"ballistic\"", "\"balistic\"")),
              ElementsAre("/claims/0/law: not one of the allowed values"));
  for (const ClaimName& claim : ClaimNames()) {
    EXPECT_THAT(FaultsOfText(With("ballistic", claim.name)), ElementsAre());
    EXPECT_FALSE(claim.documentation.empty()) << claim.name;
  }
}

TEST(ScenarioKeys, ListEveryShape) {
  for (int i = 0; i < kShapeKinds; ++i) {
    EXPECT_NE(ExpectationOf(ValueType::kShape).find(NameOf(static_cast<ShapeKind>(i))),
              std::string_view::npos);
  }
}

}  // namespace
}  // namespace touchstone
