#include "json_schema.h"

#include <algorithm>
#include <regex>
#include <set>

namespace touchstone {
namespace {

using nlohmann::json;

class Checker {
 public:
  explicit Checker(const json& root) : root_(root) {}

  void Check(const json& schema, const json& value, const std::string& path) {
    static const std::set<std::string> kKnown = {
        "$schema", "$id", "$defs", "$ref", "title", "description", "type", "const",
        "enum", "anyOf", "required", "properties", "additionalProperties", "items",
        "minItems", "maxItems", "minimum", "if", "then", "else", "allOf", "oneOf", "not",
        "pattern", "minLength", "maximum", "exclusiveMinimum", "minProperties",
        "maxProperties", "propertyNames",
        // Only shown by editors.
        "enumDescriptions", "x-taplo"};
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
    CheckScalar(schema, value, path);
    CheckChoices(schema, value, path);
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

  bool Fits(const json& schema, const json& value) const {
    Checker attempt(root_);
    attempt.Check(schema, value, "");
    return attempt.faults.empty();
  }

  void CheckScalar(const json& schema, const json& value, const std::string& path) {
    if (value.is_number()) {
      if (schema.contains("minimum") && value < schema["minimum"])
        Report(path, "minimum");
      if (schema.contains("maximum") && value > schema["maximum"])
        Report(path, "maximum");
      if (schema.contains("exclusiveMinimum") && value <= schema["exclusiveMinimum"])
        Report(path, "exclusiveMinimum");
    }
    if (!value.is_string()) return;
    const std::string text = value.get<std::string>();
    if (schema.contains("minLength") && text.size() < schema["minLength"])
      Report(path, "minLength");
    if (schema.contains("pattern") &&
        !std::regex_search(text, std::regex(schema["pattern"].get<std::string>())))
      Report(path, "pattern");
  }

  void CheckChoices(const json& schema, const json& value, const std::string& path) {
    if (schema.contains("if")) {
      const char* const then = Fits(schema["if"], value) ? "then" : "else";
      if (schema.contains(then)) Check(schema[then], value, path);
    }
    for (const json& part : schema.value("allOf", json::array()))
      Check(part, value, path);
    if (schema.contains("not") && Fits(schema["not"], value)) Report(path, "not");
    if (!schema.contains("oneOf")) return;
    int fitting = 0;
    for (const json& choice : schema["oneOf"]) fitting += Fits(choice, value);
    if (fitting != 1) Report(path, "fits " + std::to_string(fitting) + " of oneOf");
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
    if (schema.contains("minProperties") && value.size() < schema["minProperties"])
      Report(path, "minProperties");
    if (schema.contains("maxProperties") && value.size() > schema["maxProperties"])
      Report(path, "maxProperties");
    const json properties = schema.value("properties", json::object());
    const json others = schema.value("additionalProperties", json(true));
    for (const auto& [name, child] : value.items()) {
      if (schema.contains("propertyNames")) Check(schema["propertyNames"], name, path);
      if (properties.contains(name)) {
        Check(properties[name], child, path + "/" + name);
      } else if (others.is_object()) {
        Check(others, child, path + "/" + name);
      } else if (others == false) {
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
