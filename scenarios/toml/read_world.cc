#include "scenarios/toml/read_world.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scenarios/toml/read_expectations.h"
#include "scenarios/toml/read_world_parts.h"
#include "scenarios/toml/values.h"
#include "scenarios/toml/world_names.h"
#include "scenarios/worlds/magnitudes.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

/** Builds the world, and reports invalid values that have the right type. */
class Build {
 public:
  Build(const toml::table& file, FileLog& log)
      : file_(file), log_(log), names_(file, log) {}

  /** Reads the list [[expect]] of the world that was built. */
  std::vector<MotionExpectation> Expectations(const std::filesystem::path& folder) {
    return ExpectationsFrom(file_, {world_, clock_is_good_, folder}, names_, log_);
  }

  /** Builds the world, which the other functions read too. */
  const World& operator()() {
    AddNamed("bodies", world_.bodies, RigidBodyFrom);
    AddNamed("particles", world_.particles, ParticleFrom);
    AddNamed("cloths", world_.cloths, ClothFrom);
    AddClock();
    AddTied("springs", world_.springs, [](const toml::table& table, double distance) {
      Spring spring;
      spring.stiffness = NumberFrom(table.get("stiffness"), 0);
      spring.damping = NumberFrom(table.get("damping"), 0);
      spring.rest_length = NumberFrom(table.get("rest_length"), distance);
      return spring;
    });
    AddTied("joints", world_.joints, [](const toml::table& table, double distance) {
      DistanceJoint joint;
      joint.length = NumberFrom(table.get("length"), distance);
      return joint;
    });
    AddPushes();
    log_.Add(FaultsOfMagnitudes(world_), file_, "");
    if (file_["world"].is_table() && !Moves(world_)) {
      log_.Add(file_["world"].node()->source(), "world has nothing that moves",
               "a body, a particle or a cloth that can move");
    }
    return world_;
  }

  std::vector<Claim> Claims() {
    std::vector<Claim> claims;
    for (const toml::table* table : TablesFrom(file_, "claims")) {
      const std::string path = fmt::format("claims[{}].", claims.size());
      claims.emplace_back();
      if (table) claims.back() = ClaimFrom(*table, path);
    }
    return claims;
  }

 private:
  template <class Part>
  void AddNamed(std::string_view key, std::vector<Part>& parts,
                Part (*from)(const toml::table&, FileLog&)) {
    for (const auto& [name, table] : InFileOrder(file_, key)) {
      Part part = table ? from(*table, log_) : Part();
      part.name = name->str();
      if (table) {
        log_.Add(FaultsOf(part), *table, fmt::format("{}.{}.", key, part.name));
      }
      parts.push_back(std::move(part));
    }
  }

  void AddClock() {
    const toml::table* table = file_["world"].as_table();
    if (!table) return;
    world_.gravity_W = VectorFrom(table->get("gravity"), world_.gravity_W);
    world_.dt = NumberFrom(table->get("dt"), world_.dt);
    world_.sample_every = IntegerFrom(table->get("sample_every"), world_.sample_every);
    const bool has_steps = SetSteps(*table);
    std::vector<Fault> faults = FaultsOfClock(world_);
    if (!has_steps) {
      // Without a number of steps, sample_every cannot be checked as its divisor.
      std::erase_if(faults, [](const Fault& fault) {
        return fault.where == "steps" || fault.where == "sample_every";
      });
    }
    log_.Add(faults, *table, "world.");
    clock_is_good_ = has_steps && (*table)["dt"].is_number() && faults.empty();
  }

  /** Sets the number of steps, and returns whether the file determines it. */
  bool SetSteps(const toml::table& table) {
    const toml::node* duration = table.get("duration");
    const toml::node* steps = table.get("steps");
    if (duration && steps) {
      log_.Add(duration->source(), "world has steps and a duration", "one of the two");
      return false;
    }
    if (!duration && !steps) {
      log_.Add(table.source(), "world.steps is missing",
               "a count, 1 or more, or a duration");
      return false;
    }
    if (steps) {
      world_.steps = IntegerFrom(steps, world_.steps);
      return steps->is_integer() && std::in_range<int>(steps->as_integer()->get());
    }
    if (!duration->is_number() || !(world_.dt > 0 && std::isfinite(world_.dt))) {
      return false;
    }
    const double seconds = NumberFrom(duration, 0);
    const double count = std::round(seconds / world_.dt);
    if (!(count >= 1 && count <= kMostSteps)) {
      log_.Add(duration->source(), fmt::format("world.duration is {}", seconds),
               fmt::format("1 to {} steps of {} s", kMostSteps, world_.dt));
    } else if (!(std::abs(seconds / world_.dt - count) <= kStepSlack)) {
      log_.Add(duration->source(), fmt::format("world.duration is {}", seconds),
               fmt::format("a multiple of dt = {}", world_.dt));
    } else {
      world_.steps = static_cast<int>(count);
      return true;
    }
    return false;
  }

  /** Adds springs or joints. `from` builds one from its table and the distance between
   its ends, which is the default length. */
  template <class Part, class From>
  void AddTied(std::string_view key, std::vector<Part>& parts, const From& from) {
    for (const toml::table* table : TablesFrom(file_, key)) {
      const std::string path = fmt::format("{}[{}].", key, parts.size());
      parts.emplace_back();
      if (!table) continue;
      const std::optional<Anchor> A = names_.AnchorFrom(table->get("A"), path + 'A');
      const std::optional<Anchor> B = names_.AnchorFrom(table->get("B"), path + 'B');
      const std::vector<Fault> of_ends =
          A && B ? FaultsOfEnds(world_, *A, *B) : std::vector<Fault>();
      log_.Add(of_ends, *table, path);
      constexpr double kHarmless = 1;
      const bool apart = A && B && of_ends.empty();
      parts.back() = from(
          *table, apart ? (StartOf(world_, *A) - StartOf(world_, *B)).norm() : kHarmless);
      log_.Add(FaultsOf(parts.back()), *table, path);
      parts.back().A = A.value_or(Anchor());
      parts.back().B = B.value_or(Anchor());
    }
  }

  void AddPushes() {
    for (const toml::table* table : TablesFrom(file_, "pushes")) {
      const std::string path = fmt::format("pushes[{}].", world_.pushes.size());
      world_.pushes.emplace_back();
      if (!table) continue;
      const std::optional<int> body = names_.BodyFrom(table->get("body"), path + "body");
      Push& push = world_.pushes.back();
      push.body = body.value_or(0);
      push.time = NumberFrom(table->get("time"), push.time);
      push.p_BoP = VectorFrom(table->get("point"), push.p_BoP);
      push.J_W = VectorFrom(table->get("impulse"), push.J_W);
      log_.Add(FaultsOf(push), *table, path);
      if (body && clock_is_good_) log_.Add(FaultsIn(world_, push), *table, path);
    }
  }

  Claim ClaimFrom(const toml::table& table, const std::string& path) {
    Claim claim;
    claim.law = TextFrom(table, "law");
    claim.because = TextFrom(table, "because");
    if (const toml::table* numbers = table["numbers"].as_table()) {
      for (const auto& [name, number] : *numbers) {
        claim.numbers.emplace(name.str(), NumberFrom(&number, 0));
      }
    }
    if (const toml::array* about = table["about"].as_array()) {
      for (std::size_t i = 0; i < about->size(); ++i) {
        const std::string where = fmt::format("{}about[{}]", path, i);
        claim.about.push_back(names_.AnyFrom(about->get(i), where).value_or(where));
      }
    }
    std::vector<Fault> faults = FaultsOf(claim);
    // CheckStructure() has already reported invalid names.
    std::erase_if(faults, [](const Fault& fault) {
      return fault.where == "law" || fault.where == "numbers";
    });
    log_.Add(faults, table, path);
    return claim;
  }

  const toml::table& file_;
  FileLog& log_;
  WorldNames names_;
  World world_;
  bool clock_is_good_ = false;
};

}  // namespace

WorldScenario WorldFrom(const toml::table& file, const std::filesystem::path& folder,
                        FileLog& log) {
  WorldScenario scenario;
  scenario.id = TextFrom(file, "id");
  scenario.title = TextFrom(file, "title");
  scenario.source = TextFrom(file, "source");
  if (file["horizon"].is_number()) {
    scenario.horizon = NumberFrom(file.get("horizon"), 0);
    log.Add(FaultsOfHorizon(*scenario.horizon), file, "");
  }
  Build build(file, log);
  scenario.world = build();
  scenario.claims = build.Claims();
  scenario.expectations = build.Expectations(folder);
  if (const toml::table* table = file["ensemble"].as_table()) {
    Ensemble& ensemble = scenario.ensemble.emplace();
    ensemble.members = IntegerFrom(table->get("members"), 2);
    ensemble.jitter = NumberFrom(table->get("jitter"), 1);
    ensemble.seed = IntegerFrom(table->get("seed"), ensemble.seed);
    log.Add(FaultsOf(ensemble), *table, "ensemble.");
  }
  scenario.indicts = IndictmentsFrom(file);
  return scenario;
}

}  // namespace touchstone
