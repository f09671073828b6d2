#include "scenarios/toml/read_contact.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/schema/nearest_name.h"
#include "scenarios/toml/read_body.h"
#include "scenarios/toml/values.h"
#include "scenarios/validate_scenario.h"

namespace touchstone {
namespace {

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
  if (expect["contacts"].is_integer()) {
    expectation.contacts = IntegerFrom(expect.get("contacts"), 0);
  }
  return expectation;
}

/** Builds the scenario, and reports invalid values that have the right type. */
class Build {
 public:
  Build(const toml::table& file, FileLog& log) : file_(file), log_(log) {}

  Scenario operator()() {
    Scenario scenario;
    scenario.id = TextFrom(file_, "id");
    scenario.title = TextFrom(file_, "title");
    scenario.source = TextFrom(file_, "source");
    AddQuestion(scenario);
    if (const toml::table* expect = file_["expect"].as_table()) {
      scenario.expect = ExpectationFrom(*expect);
      log_.Add(FaultsOf(scenario.expect), *expect, "expect.");
    }
    if (const toml::table* tolerance = file_["tolerance"].as_table()) {
      scenario.tolerance = {NumberFrom(tolerance->get("separation"), 1),
                            TextFrom(*tolerance, "because")};
      // CheckStructure() has already reported an empty reason.
      std::vector<Fault> faults = FaultsOf(*scenario.tolerance);
      std::erase_if(faults, [](const Fault& fault) { return fault.where == "because"; });
      log_.Add(faults, *tolerance, "tolerance.");
    }
    scenario.indicts = IndictmentsFrom(file_);
    return scenario;
  }

 private:
  void AddQuestion(Scenario& scenario) {
    const toml::table* bodies = file_["bodies"].as_table();
    if (!bodies) return;
    const toml::table* A = BodyNamed(*bodies, "A", scenario.name_A);
    const toml::table* B = BodyNamed(*bodies, "B", scenario.name_B);
    for (const auto& [name, node] : *bodies) {
      const toml::table* table = node.as_table();
      if (!table) continue;
      const Body body = BodyFrom(*table, log_);
      log_.Add(FaultsOf(body), *table, fmt::format("bodies.{}.", name.str()));
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
               fmt::format("contact.B is \"{}\", the same as contact.A", scenario.name_B),
               "another body");
    } else if (A && B && KindOf(scenario.contact.A.shape) == ShapeKind::kHalfSpace &&
               KindOf(scenario.contact.B.shape) == ShapeKind::kHalfSpace) {
      log_.Add(B->get("shape")->source(),
               fmt::format("bodies.{}.shape is \"half_space\", like that of bodies.{}",
                           scenario.name_B, scenario.name_A),
               "at most one half_space");
    }
  }

  /** Returns the table of the body that contact.`role` names, and sets `name` to its
   name; null if there is no such body. */
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
             fmt::format("contact.{} is \"{}\", which is not a body", role, name),
             !nearest.empty() ? fmt::format("\"{}\"", nearest)
             : names.empty()  ? "a table of [bodies]"
                              : fmt::format("one of {}", fmt::join(names, ", ")));
    return nullptr;
  }

  const toml::table& file_;
  FileLog& log_;
};

}  // namespace

Scenario ContactFrom(const toml::table& file, FileLog& log) {
  return Build(file, log)();
}

}  // namespace touchstone
