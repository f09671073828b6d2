#include "scenarios/toml/check_structure.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/measure_kind.h"
#include "scenarios/schema/nearest_name.h"
#include "scenarios/validate_scenario.h"

namespace touchstone {
namespace {

std::string_view TypeOf(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a floating-point number";
    case toml::node_type::boolean:
      return "a boolean";
    case toml::node_type::date:
      return "a date";
    case toml::node_type::time:
      return "a time";
    case toml::node_type::date_time:
      return "a date and time";
    case toml::node_type::none:
      break;
  }
  return "nothing";
}

std::optional<ShapeKind> ShapeNamed(std::string_view name) {
  for (int kind = 0; kind < kShapeKinds; ++kind) {
    if (NameOf(static_cast<ShapeKind>(kind)) == name) return static_cast<ShapeKind>(kind);
  }
  return std::nullopt;
}

/** Returns the keys that `body` may have: those of its shape, or those of all shapes if
 the shape's name is misspelt. */
std::vector<Key> KeysOfBody(const toml::table& body, bool may_move) {
  std::vector<Key> keys(BodyKeys().begin(), BodyKeys().end());
  const std::optional<ShapeKind> kind =
      ShapeNamed(body["shape"].value_or(std::string_view()));
  for (int i = 0; i < kShapeKinds; ++i) {
    if (kind && static_cast<ShapeKind>(i) != *kind) continue;
    for (Key key : ShapeKeys(static_cast<ShapeKind>(i))) {
      // A misspelt shape is one error: its keys are not also reported as unknown or
      // missing.
      key.required = kind.has_value();
      keys.push_back(key);
    }
  }
  if (may_move) keys.insert(keys.end(), MotionKeys().begin(), MotionKeys().end());
  return keys;
}

class StructureCheck {
 public:
  StructureCheck(TableKind kind, FileLog& log) : kind_(kind), log_(log) {}

  void File(const toml::table& file) { Table(file, "", KeysOf(kind_)); }

 private:
  /** Checks `table`. `where` is its path, e.g. "bodies.ball"; empty for the file. */
  void Table(const toml::table& table, std::string_view where,
             std::span<const Key> keys) {
    std::vector<std::string_view> meant;
    for (const auto& [name, node] : table) {
      const auto key =
          std::find_if(keys.begin(), keys.end(),
                       [&name = name](const Key& k) { return k.name == name.str(); });
      if (key == keys.end()) {
        meant.push_back(UnknownKey(name, where, keys));
      } else {
        Value(node, Join(where, key->name), *key);
      }
    }
    for (const Key& key : keys) {
      // A misspelt key is one error: it is not also reported as missing.
      if (!key.required || table.contains(key.name) ||
          std::find(meant.begin(), meant.end(), key.name) != meant.end()) {
        continue;
      }
      if (key.table == TableKind::kContact) {
        log_.Add(table.source(), "neither [contact] nor [world] is present",
                 "one of the two");
        continue;
      }
      log_.Add(table.source(), fmt::format("{} is missing", Join(where, key.name)),
               ExpectationOf(key.type));
    }
  }

  static std::string Join(std::string_view where, std::string_view key) {
    return where.empty() ? std::string(key) : fmt::format("{}.{}", where, key);
  }

  /** Reports the unknown key `name` and returns the key that it most likely means; empty
   if there is none. */
  std::string_view UnknownKey(const toml::key& name, std::string_view where,
                              std::span<const Key> keys) {
    if (where.empty() && IsKeyOfAnotherFile(name.str())) {
      log_.Add(name.source(),
               fmt::format("\"{}\" is not allowed in a file with [{}]", name.str(),
                           kind_ == TableKind::kWorldFile ? "world" : "contact"),
               "one question per file");
      return {};
    }
    std::vector<std::string_view> known;
    for (const Key& key : keys) known.push_back(key.name);
    const std::string_view nearest = NearestName(name.str(), known);
    log_.Add(name.source(),
             fmt::format("unknown key \"{}\"{}{}", name.str(),
                         where.empty() ? "" : " in ", where),
             Meant(nearest, known));
    return nearest;
  }

  /** Returns the text of what is expected: `nearest`, or all known names if it is empty.
   */
  static std::string Meant(std::string_view nearest,
                           std::span<const std::string_view> known) {
    return nearest.empty() ? fmt::format("one of {}", fmt::join(known, ", "))
                           : fmt::format("\"{}\"", nearest);
  }

  bool IsKeyOfAnotherFile(std::string_view name) const {
    const std::span<const Key> keys = KeysOf(
        kind_ == TableKind::kWorldFile ? TableKind::kContactFile : TableKind::kWorldFile);
    return std::any_of(keys.begin(), keys.end(),
                       [name](const Key& key) { return key.name == name; });
  }

  void Value(const toml::node& node, const std::string& where, const Key& key) {
    switch (key.type) {
      case ValueType::kText:
      case ValueType::kBodyName:
      case ValueType::kId:
      case ValueType::kWord:
      case ValueType::kShape:
        return Text(node, where, key.type);
      case ValueType::kNames:
        return Names(node, where);
      case ValueType::kMeasures:
        return Measures(node, where);
      case ValueType::kBool:
        if (!node.is_boolean()) WrongType(node, where, key.type);
        return;
      case ValueType::kCount:
      case ValueType::kPositiveCount:
        return Integer<int>(node, where, key.type);
      case ValueType::kSeed:
        return Integer<std::uint32_t>(node, where, key.type);
      case ValueType::kNumber:
      case ValueType::kNotNegative:
      case ValueType::kPositive:
      case ValueType::kLength:
      case ValueType::kShare:
        if (!node.is_number()) WrongType(node, where, key.type);
        return;
      case ValueType::kPoint:
      case ValueType::kLengths:
      case ValueType::kMoments:
        return Numbers(node, where, 3, key.type);
      case ValueType::kQuaternion:
        return Numbers(node, where, 4, key.type);
      case ValueType::kRotation:
      case ValueType::kPoints:
      case ValueType::kUnitVectors:
        return Rows(node, where, key.type);
      case ValueType::kNodes:
        return Nodes(node, where);
      case ValueType::kAnchor:
        return Anchor(node, where);
      case ValueType::kNumbers:
        return NamedNumbers(node, where);
      case ValueType::kTable:
        if (const toml::table* table = node.as_table()) {
          return Table(*table, where, KeysOf(key.table));
        }
        return WrongType(node, where, key.type);
      case ValueType::kBodies:
      case ValueType::kMovingBodies:
      case ValueType::kNamedTables:
        return NamedTables(node, where, key);
      case ValueType::kTables:
        return Tables(node, where, key);
    }
  }

  void WrongType(const toml::node& node, std::string_view where, ValueType type) {
    log_.Add(node.source(), fmt::format("{} is {}", where, TypeOf(node)),
             ExpectationOf(type));
  }

  void Text(const toml::node& node, const std::string& where, ValueType type) {
    const auto* text = node.as_string();
    if (!text) return WrongType(node, where, type);
    if (type == ValueType::kText && text->get().empty()) {
      log_.Add(node.source(), fmt::format("{} is empty", where), ExpectationOf(type));
    } else if ((type == ValueType::kId && !IsScenarioId(text->get())) ||
               (type == ValueType::kWord && !IsWord(text->get())) ||
               (type == ValueType::kShape && !ShapeNamed(text->get()))) {
      log_.Add(node.source(), fmt::format("{} is \"{}\"", where, text->get()),
               ExpectationOf(type));
    }
  }

  void Names(const toml::node& node, const std::string& where) {
    const toml::array* array = node.as_array();
    if (!array) return WrongType(node, where, ValueType::kNames);
    for (std::size_t i = 0; i < array->size(); ++i) {
      Text(*array->get(i), fmt::format("{}[{}]", where, i), ValueType::kBodyName);
    }
  }

  void Measures(const toml::node& node, const std::string& where) {
    const toml::array* array = node.as_array();
    if (!array) return WrongType(node, where, ValueType::kMeasures);
    if (array->empty()) {
      log_.Add(node.source(), fmt::format("{} is empty", where),
               ExpectationOf(ValueType::kMeasures));
    }
    std::vector<std::string_view> known;
    for (const MeasureKind measure : AllMeasures()) known.push_back(NameOf(measure));
    for (std::size_t i = 0; i < array->size(); ++i) {
      const std::string element = fmt::format("{}[{}]", where, i);
      const auto* text = array->get(i)->as_string();
      if (!text) {
        WrongType(*array->get(i), element, ValueType::kText);
      } else if (!MeasureNamed(text->get())) {
        log_.Add(array->get(i)->source(),
                 fmt::format("{} is \"{}\"", element, text->get()),
                 Meant(NearestName(text->get(), known), known));
      }
    }
  }

  template <class Type>
  void Integer(const toml::node& node, std::string_view where, ValueType type) {
    const auto* integer = node.as_integer();
    if (!integer) return WrongType(node, where, type);
    if (!std::in_range<Type>(integer->get())) {
      log_.Add(node.source(), fmt::format("{} is {}", where, integer->get()),
               ExpectationOf(type));
    }
  }

  void Numbers(const toml::node& node, std::string_view where, std::size_t size,
               ValueType type) {
    const toml::array* array = node.as_array();
    if (!array) return WrongType(node, where, type);
    if (array->size() != size) {
      log_.Add(node.source(), fmt::format("{} has {} elements", where, array->size()),
               ExpectationOf(type));
    }
    for (std::size_t i = 0; i < array->size(); ++i) {
      const toml::node& element = *array->get(i);
      if (!element.is_number()) {
        WrongType(element, fmt::format("{}[{}]", where, i), ValueType::kNumber);
      }
    }
  }

  void Rows(const toml::node& node, std::string_view where, ValueType type) {
    const toml::array* array = node.as_array();
    if (!array) return WrongType(node, where, type);
    if (type == ValueType::kRotation && array->size() != 3) {
      log_.Add(node.source(), fmt::format("{} has {} elements", where, array->size()),
               ExpectationOf(type));
    }
    for (std::size_t i = 0; i < array->size(); ++i) {
      Numbers(*array->get(i), fmt::format("{}[{}]", where, i), 3, ValueType::kPoint);
    }
  }

  void Nodes(const toml::node& node, std::string_view where) {
    const toml::array* array = node.as_array();
    if (!array) return WrongType(node, where, ValueType::kNodes);
    for (std::size_t i = 0; i < array->size(); ++i) {
      const std::string pair = fmt::format("{}[{}]", where, i);
      const toml::array* row_and_column = array->get(i)->as_array();
      if (!row_and_column || row_and_column->size() != 2) {
        log_.Add(array->get(i)->source(), fmt::format("{} is not a node", pair),
                 "[row, column]");
        continue;
      }
      for (std::size_t j = 0; j < 2; ++j) {
        Integer<int>(*row_and_column->get(j), fmt::format("{}[{}]", pair, j),
                     ValueType::kCount);
      }
    }
  }

  void Anchor(const toml::node& node, const std::string& where) {
    if (const toml::table* table = node.as_table()) {
      Table(*table, where, KeysOf(TableKind::kAnchor));
    } else if (node.is_array()) {
      Numbers(node, where, 3, ValueType::kPoint);
    } else if (!node.is_string()) {
      WrongType(node, where, ValueType::kAnchor);
    }
  }

  void NamedNumbers(const toml::node& node, std::string_view where) {
    const toml::table* table = node.as_table();
    if (!table) return WrongType(node, where, ValueType::kNumbers);
    for (const auto& [name, number] : *table) {
      Name(name, "a number", "a-z, 0-9 and _", IsWord(name.str()));
      if (!number.is_number()) {
        WrongType(number, Join(where, name.str()), ValueType::kNumber);
      }
    }
  }

  void Tables(const toml::node& node, std::string_view where, const Key& key) {
    const toml::array* array = node.as_array();
    if (!array) return WrongType(node, where, key.type);
    for (std::size_t i = 0; i < array->size(); ++i) {
      const std::string element = fmt::format("{}[{}]", where, i);
      if (const toml::table* table = array->get(i)->as_table()) {
        Table(*table, element, KeysOf(key.table));
      } else {
        WrongType(*array->get(i), element, ValueType::kTable);
      }
    }
  }

  void NamedTables(const toml::node& node, std::string_view where, const Key& key) {
    const toml::table* tables = node.as_table();
    if (!tables) return WrongType(node, where, key.type);
    for (const auto& [name, named] : *tables) {
      Name(name, KindOfTable(key), "A-Z, a-z, 0-9, _ and -", IsBodyName(name.str()));
      const std::string path = Join(where, name.str());
      if (const toml::table* table = named.as_table()) {
        NamedTable(*table, path, key);
      } else {
        WrongType(named, path, ValueType::kTable);
      }
    }
  }

  void NamedTable(const toml::table& table, std::string_view path, const Key& key) {
    if (key.type == ValueType::kNamedTables) {
      return Table(table, path, KeysOf(key.table));
    }
    Table(table, path, KeysOfBody(table, key.type == ValueType::kMovingBodies));
    if (table.contains("quaternion") && table.contains("rotation")) {
      log_.Add(table.get("rotation")->source(),
               fmt::format("{} has a quaternion and a rotation", path), "one of the two");
    }
  }

  static std::string_view KindOfTable(const Key& key) {
    if (key.type != ValueType::kNamedTables) return "a body";
    return key.table == TableKind::kCloth ? "a cloth" : "a particle";
  }

  void Name(const toml::key& name, std::string_view of, std::string_view letters,
            bool good) {
    if (good) return;
    log_.Add(name.source(), fmt::format("{} is named \"{}\"", of, name.str()),
             fmt::format("a name of {}", letters));
  }

  const TableKind kind_;  ///< Kind of the file.
  FileLog& log_;
};

}  // namespace

void CheckStructure(const toml::table& file, TableKind kind, FileLog& log) {
  StructureCheck(kind, log).File(file);
}

}  // namespace touchstone
