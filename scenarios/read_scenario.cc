#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
// toml++ 3.3 asserts what a file may well get wrong (a line break after the '[' of a
// table) before it checks the same and reports it. The check suffices; an abort would not
// do.
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>

#include "scenarios/scenario_file.h"
#include "scenarios/schema/nearest_name.h"
#include "scenarios/schema/scenario_keys.h"
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

/** Collects the diagnostics of one file. */
class Log {
 public:
  explicit Log(std::string_view file) : file_(file) {}

  void Add(const toml::source_region& at, std::string what, std::string_view expected) {
    diagnostics_.push_back({file_, static_cast<int>(at.begin.line),
                            static_cast<int>(at.begin.column), std::move(what),
                            std::string(expected)});
  }

  std::vector<Diagnostic> InOrderOfLines() && {
    std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                       return std::tie(a.line, a.column) < std::tie(b.line, b.column);
                     });
    return std::move(diagnostics_);
  }

 private:
  std::string file_;
  std::vector<Diagnostic> diagnostics_;
};

/** Checks that a file has the keys it must, none that it may not, and values of their
 types. Whether a number of the right type is a good one is for FaultsOf() to say. */
class StructureCheck {
 public:
  explicit StructureCheck(Log& log) : log_(log) {}

  void File(const toml::table& file) { Table(file, "", KeysOf(TableKind::kFile)); }

 private:
  static std::string Join(std::string_view where, std::string_view key) {
    return where.empty() ? std::string(key) : fmt::format("{}.{}", where, key);
  }

  void Table(const toml::table& table, std::string_view where,
             std::span<const Key> keys) {
    for (const auto& [name, node] : table) {
      const auto key =
          std::find_if(keys.begin(), keys.end(),
                       [&name = name](const Key& k) { return k.name == name.str(); });
      if (key == keys.end()) {
        UnknownKey(name, where, keys);
      } else {
        Value(node, Join(where, key->name), *key);
      }
    }
    for (const Key& key : keys) {
      if (!key.required || table.contains(key.name)) continue;
      log_.Add(table.source(), fmt::format("{} is missing", Join(where, key.name)),
               ExpectationOf(key.type));
    }
  }

  void UnknownKey(const toml::key& name, std::string_view where,
                  std::span<const Key> keys) {
    std::vector<std::string_view> known;
    for (const Key& key : keys) known.push_back(key.name);
    const std::string_view nearest = NearestName(name.str(), known);
    log_.Add(name.source(),
             fmt::format("unknown key \"{}\"{}{}", name.str(),
                         where.empty() ? "" : " in ", where),
             nearest.empty() ? fmt::format("one of {}", fmt::join(known, ", "))
                             : fmt::format("\"{}\"", nearest));
  }

  void Value(const toml::node& node, const std::string& where, const Key& key) {
    switch (key.type) {
      case ValueType::kText:
      case ValueType::kBodyName:
      case ValueType::kId:
      case ValueType::kShape:
        return Text(node, where, key.type);
      case ValueType::kBool:
        if (!node.is_boolean()) WrongType(node, where, key.type);
        return;
      case ValueType::kCount:
        return Count(node, where);
      case ValueType::kNumber:
      case ValueType::kLength:
        if (!node.is_number()) WrongType(node, where, key.type);
        return;
      case ValueType::kPoint:
      case ValueType::kLengths:
        return Numbers(node, where, 3, key.type);
      case ValueType::kQuaternion:
        return Numbers(node, where, 4, key.type);
      case ValueType::kRotation:
      case ValueType::kPoints:
      case ValueType::kUnitVectors:
        return Rows(node, where, key.type);
      case ValueType::kTable:
        if (const toml::table* table = node.as_table()) {
          return Table(*table, where, KeysOf(key.table));
        }
        return WrongType(node, where, key.type);
      case ValueType::kBodies:
        return Bodies(node, where);
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
               (type == ValueType::kShape && !ShapeNamed(text->get()))) {
      log_.Add(node.source(), fmt::format("{} is \"{}\"", where, text->get()),
               ExpectationOf(type));
    }
  }

  void Count(const toml::node& node, std::string_view where) {
    const auto* count = node.as_integer();
    if (!count) return WrongType(node, where, ValueType::kCount);
    if (!std::in_range<int>(count->get())) {
      log_.Add(node.source(), fmt::format("{} is {}", where, count->get()),
               ExpectationOf(ValueType::kCount));
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

  void Bodies(const toml::node& node, std::string_view where) {
    const toml::table* bodies = node.as_table();
    if (!bodies) return WrongType(node, where, ValueType::kBodies);
    for (const auto& [name, body] : *bodies) {
      if (!IsBodyName(name.str())) {
        log_.Add(name.source(), fmt::format("a body is named \"{}\"", name.str()),
                 "a name of A-Z, a-z, 0-9, _ and -");
      }
      const std::string path = Join(where, name.str());
      if (const toml::table* table = body.as_table()) {
        Table(*table, path, KeysOfBody(*table));
        if (table->contains("quaternion") && table->contains("rotation")) {
          log_.Add(table->get("rotation")->source(),
                   fmt::format("{} has a quaternion and a rotation", path),
                   "one of the two");
        }
      } else {
        WrongType(body, path, ValueType::kTable);
      }
    }
  }

  static std::optional<ShapeKind> ShapeNamed(std::string_view name) {
    for (int kind = 0; kind < kShapeKinds; ++kind) {
      if (NameOf(static_cast<ShapeKind>(kind)) == name)
        return static_cast<ShapeKind>(kind);
    }
    return std::nullopt;
  }

  static std::vector<Key> KeysOfBody(const toml::table& body) {
    std::vector<Key> keys(BodyKeys().begin(), BodyKeys().end());
    const std::optional<ShapeKind> kind =
        ShapeNamed(body["shape"].value_or(std::string_view()));
    for (int i = 0; i < kShapeKinds; ++i) {
      if (kind && static_cast<ShapeKind>(i) != *kind) continue;
      for (Key key : ShapeKeys(static_cast<ShapeKind>(i))) {
        // A shape misspelt is one error: its keys are not called unknown or missing as
        // well.
        key.required = kind.has_value();
        keys.push_back(key);
      }
    }
    return keys;
  }

  Log& log_;
};

// Each of these takes what has the right type and a harmless value for all else, which
// StructureCheck has reported already: so one error does not hide another.

double NumberFrom(const toml::node* node, double otherwise) {
  if (const auto* number = node ? node->as_floating_point() : nullptr)
    return number->get();
  // node::value<double>() would refuse an integer beyond 2^53, which is as good a decimal
  // as any other.
  if (const auto* integer = node ? node->as_integer() : nullptr) {
    return static_cast<double>(integer->get());
  }
  return otherwise;
}

bool AreNumbers(const toml::node* node, std::size_t size) {
  const toml::array* array = node ? node->as_array() : nullptr;
  return array && array->size() == size &&
         std::all_of(array->begin(), array->end(),
                     [](const toml::node& element) { return element.is_number(); });
}

std::string TextFrom(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string());
}

Eigen::Vector3d VectorFrom(const toml::node* node, const Eigen::Vector3d& otherwise) {
  const toml::array* array = node ? node->as_array() : nullptr;
  if (!array || array->size() != 3) return otherwise;
  return {NumberFrom(array->get(0), otherwise[0]),
          NumberFrom(array->get(1), otherwise[1]),
          NumberFrom(array->get(2), otherwise[2])};
}

std::vector<Eigen::Vector3d> PointsFrom(const toml::array& array) {
  std::vector<Eigen::Vector3d> points;
  for (const toml::node& element : array) {
    points.push_back(VectorFrom(&element, Eigen::Vector3d::Zero()));
  }
  return points;
}

Shape ShapeFrom(const toml::table& body) {
  const std::string name = TextFrom(body, "shape");
  const auto length = [&](std::string_view key) { return NumberFrom(body.get(key), 1); };
  if (name == NameOf(ShapeKind::kSphere)) return Sphere{length("radius")};
  if (name == NameOf(ShapeKind::kBox)) {
    return Box{VectorFrom(body.get("half_extents"), Eigen::Vector3d::Ones())};
  }
  if (name == NameOf(ShapeKind::kCapsule)) {
    return Capsule{length("radius"), length("half_length")};
  }
  if (name == NameOf(ShapeKind::kCylinder)) {
    return Cylinder{length("radius"), length("half_length")};
  }
  if (name == NameOf(ShapeKind::kCone)) {
    return Cone{length("radius"), length("half_height")};
  }
  if (name == NameOf(ShapeKind::kConvexHull)) {
    if (const toml::array* vertices = body["vertices"].as_array()) {
      return ConvexHull{PointsFrom(*vertices)};
    }
    return ConvexHull{{Eigen::Vector3d::Zero()}};
  }
  if (name == NameOf(ShapeKind::kHalfSpace)) return HalfSpace{};
  return Sphere{1};
}

Pose PoseFrom(const toml::table& body) {
  const Eigen::Vector3d p_WB = VectorFrom(body.get("position"), Eigen::Vector3d::Zero());
  const toml::array* rows = body["rotation"].as_array();
  if (rows && rows->size() == 3 &&
      std::all_of(rows->begin(), rows->end(),
                  [](const toml::node& row) { return AreNumbers(&row, 3); })) {
    Eigen::Matrix3d R_WB;
    for (int i = 0; i < 3; ++i) {
      R_WB.row(i) =
          VectorFrom(rows->get(static_cast<std::size_t>(i)), Eigen::Vector3d::Unit(i));
    }
    return Pose::FromMatrix(p_WB, R_WB);
  }
  if (AreNumbers(body.get("quaternion"), 4)) {
    const toml::array& wxyz = *body["quaternion"].as_array();
    return Pose::FromQuaternion(p_WB,
                                {NumberFrom(wxyz.get(0), 1), NumberFrom(wxyz.get(1), 0),
                                 NumberFrom(wxyz.get(2), 0), NumberFrom(wxyz.get(3), 0)});
  }
  return Pose::FromQuaternion(p_WB, Eigen::Quaterniond::Identity());
}

ContactExpectation ExpectationFrom(const toml::table& expect) {
  ContactExpectation expectation;
  expectation.touching = expect["touching"].value<bool>();
  if (expect["separation"].is_number()) {
    expectation.separation = NumberFrom(expect.get("separation"), 0);
  }
  if (const toml::array* normals = expect["normals"].as_array()) {
    for (const toml::node& normal : *normals) {
      const Eigen::Vector3d otherwise = Eigen::Vector3d::UnitZ();
      expectation.normals.push_back(
          AreNumbers(&normal, 3) ? VectorFrom(&normal, otherwise) : otherwise);
    }
  }
  if (const auto count = expect["contacts"].value_exact<std::int64_t>();
      count && std::in_range<int>(*count)) {
    expectation.contacts = static_cast<int>(*count);
  }
  return expectation;
}

std::vector<Indictment> IndictmentsFrom(const toml::table& file) {
  std::vector<Indictment> indictments;
  if (const toml::array* array = file["indicts"].as_array()) {
    for (const toml::node& element : *array) {
      if (const toml::table* table = element.as_table()) {
        indictments.push_back({TextFrom(*table, "oracle"), TextFrom(*table, "anomaly"),
                               (*table)["reproduces"].value_or(false)});
      }
    }
  }
  return indictments;
}

/** Builds the scenario, and reports values of the right type that cannot be. */
class Build {
 public:
  Build(const toml::table& file, Log& log) : file_(file), log_(log) {}

  Scenario operator()() {
    Scenario scenario;
    scenario.id = TextFrom(file_, "id");
    scenario.title = TextFrom(file_, "title");
    scenario.source = TextFrom(file_, "source");
    AddQuestion(scenario);
    if (const toml::table* expect = file_["expect"].as_table()) {
      scenario.expect = ExpectationFrom(*expect);
      Report(FaultsOf(scenario.expect), *expect, "expect.");
    }
    if (const toml::table* tolerance = file_["tolerance"].as_table()) {
      scenario.tolerance = {NumberFrom(tolerance->get("separation"), 1),
                            TextFrom(*tolerance, "because")};
      // An empty reason was a fault of structure.
      std::vector<Fault> faults = FaultsOf(*scenario.tolerance);
      std::erase_if(faults, [](const Fault& fault) { return fault.where == "because"; });
      Report(faults, *tolerance, "tolerance.");
    }
    scenario.indicts = IndictmentsFrom(file_);
    return scenario;
  }

 private:
  void Report(const std::vector<Fault>& faults, const toml::table& table,
              std::string_view prefix) {
    for (const Fault& fault : faults) {
      const toml::node_view<const toml::node> node = toml::at_path(table, fault.where);
      log_.Add(node ? node.node()->source() : table.source(),
               fmt::format("{}{} {}", prefix, fault.where, fault.what), fault.expected);
    }
  }

  void AddQuestion(Scenario& scenario) {
    const toml::table* bodies = file_["bodies"].as_table();
    if (!bodies) return;
    const toml::table* A = BodyNamed(*bodies, "A", scenario.name_A);
    const toml::table* B = BodyNamed(*bodies, "B", scenario.name_B);
    for (const auto& [name, node] : *bodies) {
      const toml::table* table = node.as_table();
      if (!table) continue;
      const Body body{ShapeFrom(*table), PoseFrom(*table)};
      Report(FaultsOf(body), *table, fmt::format("bodies.{}.", name.str()));
      if (table == A) scenario.contact.A = body;
      if (table == B) scenario.contact.B = body;
      if (A && B && table != A && table != B) {
        log_.Add(table->source(),
                 fmt::format("bodies.{} is not in the question", name.str()),
                 "two bodies, contact.A and contact.B");
      }
    }
    if (A && A == B) {
      log_.Add(file_["contact"]["B"].node()->source(),
               fmt::format("contact.B is \"{}\" like contact.A", scenario.name_B),
               "another body");
    } else if (A && B && KindOf(scenario.contact.A.shape) == ShapeKind::kHalfSpace &&
               KindOf(scenario.contact.B.shape) == ShapeKind::kHalfSpace) {
      log_.Add(B->get("shape")->source(),
               fmt::format("bodies.{}.shape is \"half_space\" like that of bodies.{}",
                           scenario.name_B, scenario.name_A),
               "at most one half_space");
    }
  }

  /** Returns the body that contact.`role` names, and its name; null where there is none.
   */
  const toml::table* BodyNamed(const toml::table& bodies, std::string_view role,
                               std::string& name) {
    const toml::node_view<const toml::node> node = file_["contact"][role];
    if (!node.is_string()) return nullptr;
    name = node.value_or(std::string());
    if (bodies.contains(name)) return bodies[name].as_table();
    std::vector<std::string_view> names;
    for (const auto& [body_name, body] : bodies) names.push_back(body_name.str());
    const std::string_view nearest = NearestName(name, names);
    log_.Add(node.node()->source(),
             fmt::format("contact.{} is \"{}\", which is no body", role, name),
             !nearest.empty() ? fmt::format("\"{}\"", nearest)
             : names.empty()  ? "a table of [bodies]"
                              : fmt::format("one of {}", fmt::join(names, ", ")));
    return nullptr;
  }

  const toml::table& file_;
  Log& log_;
};

}  // namespace

ReadResult ReadScenario(std::string_view text, std::string_view file_name) {
  Log log(file_name);
  ReadResult result;
  try {
    const toml::table file = toml::parse(text, file_name);
    StructureCheck(log).File(file);
    Scenario scenario = Build(file, log)();
    if (const toml::node* id = file.get("id"); id && IsScenarioId(scenario.id)) {
      result.stated_id = {scenario.id, static_cast<int>(id->source().begin.line),
                          static_cast<int>(id->source().begin.column)};
    }
    result.diagnostics = std::move(log).InOrderOfLines();
    if (result.diagnostics.empty()) result.scenario = std::move(scenario);
  } catch (const toml::parse_error& error) {
    log.Add(error.source(), std::string(error.description()), "valid TOML 1.0");
    result.diagnostics = std::move(log).InOrderOfLines();
  }
  return result;
}

}  // namespace touchstone
