#include "json_schema.h"

#include <algorithm>
#include <set>

namespace touchstone {
namespace {

using nlohmann::json;

class Checker {
 public:
  explicit Checker(const json& root) : root_(root) {}

  void Check(const json& schema, const json& value, const std::string& path) {
    static const std::set<std::string> kKnown = {"$schema",
                                                 "$id",
                                                 "$defs",
                                                 "$ref",
                                                 "title",
                                                 "description",
                                                 "type",
                                                 "const",
                                                 "enum",
                                                 "anyOf",
                                                 "required",
                                                 "properties",
                                                 "additionalProperties",
                                                 "items",
                                                 "minItems",
                                                 "maxItems",
                                                 "minimum"};
    for (const auto& [keyword, unused] : schema.items()) {
      if (!kKnown.contains(keyword)) Report(path, "schema keyword " + keyword);
    }
    if (schema.contains("$ref")) {
      const std::string name = schema["$ref"].get<std::string>().substr(8);  // "#/$defs/"
      Check(root_["$defs"].at(name), value, path);
    }
    if (schema.contains("const") && schema["const"] != value) Report(path, "const");
    if (schema.contains("enum")) {
      const json& allowed = schema["enum"];
      if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
        Report(path, "not one of the allowed values");
      }
    }
    if (schema.contains("anyOf")) CheckAnyOf(schema["anyOf"], value, path);
    if (schema.contains("type") && !HasType(schema["type"], value)) {
      Report(path, "type, expected " + schema["type"].dump());
      return;
    }
    if (schema.contains("minimum") && value < schema["minimum"]) Report(path, "minimum");
    if (value.is_object()) CheckObject(schema, value, path);
    if (value.is_array()) CheckArray(schema, value, path);
  }

  std::vector<std::string> faults;

 private:
  void Report(const std::string& path, const std::string& what) {
    faults.push_back(path + ": " + what);
  }

  static bool HasType(const json& type, const json& value) {
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    return type == std::string(value.type_name());
  }

  void CheckAnyOf(const json& choices, const json& value, const std::string& path) {
    for (const json& choice : choices) {
      Checker attempt(root_);
      attempt.Check(choice, value, path);
      if (attempt.faults.empty()) return;
    }
    Report(path, "matches none of anyOf");
  }

  void CheckObject(const json& schema, const json& value, const std::string& path) {
    if (schema.contains("required")) {
      for (const json& name : schema["required"]) {
        if (!value.contains(name)) Report(path, "lacks " + name.dump());
      }
    }
    const json properties = schema.value("properties", json::object());
    for (const auto& [name, child] : value.items()) {
      if (properties.contains(name)) {
        Check(properties[name], child, path + "/" + name);
      } else if (!schema.value("additionalProperties", true)) {
        Report(path, "unknown property " + name);
      }
    }
  }

  void CheckArray(const json& schema, const json& value, const std::string& path) {
    if (schema.contains("minItems") && value.size() < schema["minItems"]) {
      Report(path, "minItems");
    }
    if (schema.contains("maxItems") && value.size() > schema["maxItems"]) {
      Report(path, "maxItems");
    }
    if (!schema.contains("items")) return;
    for (std::size_t i = 0; i < value.size(); ++i) {
      Check(schema["items"], value[i], path + "/" + std::to_string(i));
    }
  }

  const json& root_;
};

}  // namespace

std::vector<std::string> SchemaFaults(const nlohmann::json& schema,
                                      const nlohmann::json& value) {
  Checker checker(schema);
  checker.Check(schema, value, "");
  return checker.faults;
}

}  // namespace touchstone
