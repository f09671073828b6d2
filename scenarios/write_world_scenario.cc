#include <cmath>

#include <fmt/format.h>

#include "scenarios/scenario_file.h"
#include "scenarios/toml/toml_text.h"
#include "scenarios/toml/write_parts.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

using toml_text::Line;
using toml_text::Number;
using toml_text::Text;
using toml_text::Truth;
using toml_text::Vector;

/** Returns whether `v` is the reader's default for an absent key: three zeros without a
 sign. */
bool IsPlainZero(const Eigen::Vector3d& v) {
  return v.isZero(0) && !std::signbit(v[0]) && !std::signbit(v[1]) && !std::signbit(v[2]);
}

std::string LineUnlessZero(std::string_view key, const Eigen::Vector3d& v) {
  return IsPlainZero(v) ? "" : Line(key, Vector(v));
}

std::string ClockTable(const World& world) {
  return "\n[world]\n" + Line("gravity", Vector(world.gravity_W)) +
         Line("dt", Number(world.dt)) + Line("steps", std::to_string(world.steps)) +
         Line("sample_every", std::to_string(world.sample_every));
}

std::string TableOf(const RigidBody& body) {
  std::string table = fmt::format("\n[bodies.{}]\n", body.name) + BodyLines(body.placed) +
                      Line("mass", Number(body.mass));
  if (body.inertia) table += Line("inertia", Vector(*body.inertia));
  table += LineUnlessZero("velocity", body.v_WB) + LineUnlessZero("spin", body.w_WB) +
           Line("restitution", Number(body.restitution)) +
           Line("friction", Number(body.friction)) +
           LineUnlessZero("force", body.force_W);
  if (!body.collides) table += Line("collides", Truth(false));
  return table;
}

std::string TableOf(const Particle& particle) {
  return fmt::format("\n[particles.{}]\n", particle.name) +
         Line("position", Vector(particle.p_W)) +
         LineUnlessZero("velocity", particle.v_W) + Line("mass", Number(particle.mass)) +
         Line("damping", Number(particle.damping)) +
         Line("bounce", Number(particle.bounce));
}

std::string AnchorText(const World& world, const Anchor& anchor) {
  if (anchor.on == AnchorKind::kWorld) return Vector(anchor.point);
  const auto index = static_cast<std::size_t>(anchor.index);
  const std::string name =
      Text(anchor.on == AnchorKind::kBody ? world.bodies[index].name
                                          : world.particles[index].name);
  if (IsPlainZero(anchor.point)) return name;
  return fmt::format("{{on = {}, point = {}}}", name, Vector(anchor.point));
}

std::string TableOf(const World& world, const Spring& spring) {
  return "\n[[springs]]\n" + Line("A", AnchorText(world, spring.A)) +
         Line("B", AnchorText(world, spring.B)) +
         Line("stiffness", Number(spring.stiffness)) +
         Line("damping", Number(spring.damping)) +
         Line("rest_length", Number(spring.rest_length));
}

std::string TableOf(const World& world, const DistanceJoint& joint) {
  return "\n[[joints]]\n" + Line("A", AnchorText(world, joint.A)) +
         Line("B", AnchorText(world, joint.B)) + Line("length", Number(joint.length));
}

std::string SpringsText(const ClothSprings& springs) {
  return fmt::format("{{stiffness = {}, damping = {}}}", Number(springs.stiffness),
                     Number(springs.damping));
}

std::string TableOf(const Cloth& cloth) {
  std::string table =
      fmt::format("\n[cloths.{}]\n", cloth.name) + Line("n", std::to_string(cloth.n)) +
      Line("spacing", Number(cloth.spacing)) + Line("centre", Vector(cloth.centre)) +
      Line("node_mass", Number(cloth.node_mass)) +
      Line("damping", Number(cloth.damping)) + Line("bounce", Number(cloth.bounce)) +
      Line("structural", SpringsText(cloth.structural)) +
      Line("shear", SpringsText(cloth.shear)) + Line("bend", SpringsText(cloth.bend));
  if (cloth.pinned.empty()) return table;
  std::string pinned;
  for (const auto& [row, column] : cloth.pinned) {
    pinned += fmt::format("{}[{}, {}]", pinned.empty() ? "" : ", ", row, column);
  }
  return table + Line("pinned", fmt::format("[{}]", pinned));
}

std::string TableOf(const World& world, const Push& push) {
  return "\n[[pushes]]\n" +
         Line("body", Text(world.bodies[static_cast<std::size_t>(push.body)].name)) +
         Line("time", Number(push.time)) + LineUnlessZero("point", push.p_BoP) +
         Line("impulse", Vector(push.J_W));
}

std::string TableOf(const Claim& claim) {
  std::string table = "\n[[claims]]\n" + Line("law", Text(claim.law));
  std::string about;
  for (const std::string& name : claim.about) {
    about += (about.empty() ? "" : ", ") + Text(name);
  }
  if (!about.empty()) table += Line("about", fmt::format("[{}]", about));
  std::string numbers;
  for (const auto& [name, number] : claim.numbers) {
    numbers +=
        fmt::format("{}{} = {}", numbers.empty() ? "" : ", ", name, Number(number));
  }
  if (!numbers.empty()) table += Line("numbers", fmt::format("{{{}}}", numbers));
  if (!claim.because.empty()) table += Line("because", Text(claim.because));
  return table;
}

std::string NumbersOf(const Eigen::Quaterniond& q) {
  return fmt::format("[{}, {}, {}, {}]", Number(q.w()), Number(q.x()), Number(q.y()),
                     Number(q.z()));
}

/** Returns the line that states what is expected, with its direction. */
struct StatementLines {
  std::string_view key;

  std::string operator()(const ExpectedVector& expected) const {
    return Line(key, Vector(expected.value)) +
           (expected.along ? Line("along", Vector(*expected.along)) : "");
  }
  std::string operator()(const ExpectedOrientation& expected) const {
    return Line(key, NumbersOf(expected.q_WB));
  }
  std::string operator()(const ExpectedAngle& expected) const {
    return Line(key, Number(expected.angle)) + Line("along", Vector(expected.axis));
  }
  std::string operator()(const ExpectedTouch& expected) const {
    return Line(key, Text(expected.other));
  }
  std::string operator()(const ExpectedTopple& expected) const {
    return Line(key, Truth(expected.topples));
  }
  std::string operator()(const ExpectedRest&) const { return Line(key, Truth(true)); }
  std::string operator()(const ExpectedTrajectory& expected) const {
    return Line(key, Text(expected.file));
  }
};

std::string TableOf(const MotionExpectation& expectation) {
  std::string table = "\n[[expect]]\n";
  if (!expectation.body.empty()) table += Line("body", Text(expectation.body));
  const std::string_view time = TimeKeyOf(expectation);
  if (!time.empty()) table += Line(time, Number(expectation.time));
  table += std::visit(StatementLines{KeyOf(expectation)}, expectation.what);
  if (!std::holds_alternative<ExpectedTopple>(expectation.what))
    table += Line("tolerance", Number(expectation.tolerance));
  if (!expectation.because.empty()) table += Line("because", Text(expectation.because));
  return table;
}

std::string TableOf(const Ensemble& ensemble) {
  return "\n[ensemble]\n" + Line("members", std::to_string(ensemble.members)) +
         Line("jitter", Number(ensemble.jitter)) +
         Line("seed", std::to_string(ensemble.seed));
}

}  // namespace

std::string WriteScenario(const WorldScenario& scenario) {
  const World& world = scenario.world;
  std::string file = HeadingLines(scenario.id, scenario.title, scenario.source);
  if (scenario.horizon) file += Line("horizon", Number(*scenario.horizon));
  file += ClockTable(world);
  for (const RigidBody& body : world.bodies) file += TableOf(body);
  for (const Particle& particle : world.particles) file += TableOf(particle);
  for (const Spring& spring : world.springs) file += TableOf(world, spring);
  for (const DistanceJoint& joint : world.joints) file += TableOf(world, joint);
  for (const Cloth& cloth : world.cloths) file += TableOf(cloth);
  for (const Push& push : world.pushes) file += TableOf(world, push);
  for (const Claim& claim : scenario.claims) file += TableOf(claim);
  for (const MotionExpectation& expectation : scenario.expectations)
    file += TableOf(expectation);
  if (scenario.ensemble) file += TableOf(*scenario.ensemble);
  return file + IndictmentTables(scenario.indicts);
}

}  // namespace touchstone
