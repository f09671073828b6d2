#include "reports/worlds/study/run_worlds.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "reports/threads/parallel_for.h"
#include "reports/worlds/study/judge_stability.h"
#include "reports/worlds/study/judge_variant.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/rounding_growth.h"
#include "reports/worlds/study/world_size.h"
#include "reports/worlds/study/world_variants.h"
#include "scenarios/generators/ensemble.h"
#include "scenarios/generators/random.h"

namespace touchstone {
namespace {

double BodySteps(const World& world) {
  double things = static_cast<double>(world.particles.size());
  for (const RigidBody& body : world.bodies) things += body.mass > 0 ? 1 : 0;
  for (const Cloth& cloth : world.cloths)
    things += static_cast<double>(cloth.n) * cloth.n;
  return things * world.steps;
}

/** Returns the first claim of that law, or null. */
const Claim* ClaimOf(const WorldScenario& scenario, std::string_view law) {
  const auto claim = std::find_if(scenario.claims.begin(), scenario.claims.end(),
                                  [&](const Claim& c) { return c.law == law; });
  return claim == scenario.claims.end() ? nullptr : &*claim;
}

bool Claims(const WorldScenario& scenario, std::string_view law) {
  return ClaimOf(scenario, law) != nullptr;
}

/** Returns the approximate cost of all simulations of one world by one oracle.
 [body-steps] */
double WorkOf(const WorldScenario& scenario) {
  // The step itself, half and a quarter of it, a moved start, and five variants.
  const double times = IsStudied(scenario) ? 1 + 2 + 4 + 1 + 5 : 1;
  const int members = scenario.ensemble ? scenario.ensemble->members : 1;
  return BodySteps(scenario.world) * (times + members - 1);
}

/** Number of times that the start of a stable world is moved: whether one rounding error
 opens a contact or closes it is chance. */
constexpr std::size_t kNudgesOfStable = 4;

/** The indices of a world and an oracle. */
struct Pair {
  std::size_t world;
  std::size_t oracle;
};

std::vector<Pair> PairsOf(std::span<const WorldScenario> worlds,
                          std::span<const Oracle* const> oracles) {
  std::vector<Pair> pairs;
  for (std::size_t w = 0; w < worlds.size(); ++w) {
    for (std::size_t o = 0; o < oracles.size(); ++o) {
      if (oracles[o]->info().simulates) pairs.push_back({w, o});
    }
  }
  return pairs;
}

/** Returns the order in which the pairs are simulated: the most expensive first, so that
 the last ones are short and no core idles for long at the end. */
std::vector<std::size_t> LongestFirst(std::span<const Pair> pairs,
                                      std::span<const WorldScenario> worlds) {
  std::vector<double> works;
  for (const WorldScenario& scenario : worlds) works.push_back(WorkOf(scenario));
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return works[pairs[a].world] > works[pairs[b].world];
  });
  return order;
}

/** Returns a sort key: passing or not first, then the value over its tolerance. */
std::pair<bool, double> Severity(const Finding& finding) {
  const bool passes = finding.verdict == Verdict::kPass;
  return {!passes, finding.tolerance > 0 ? finding.value / finding.tolerance : 0};
}

bool IsUnverified(const Finding& finding) {
  return finding.verdict == Verdict::kUnsupported;
}

/** Merges `others`, the findings of one ensemble member, into `findings`, those of the
 members before it: per measure the worse one is kept. Both belong to the same claim,
 which has one finding per measure. A member whose motion gives the law nothing to judge
 adds nothing; its finding is replaced by those of a member that does. */
void KeepWorst(std::vector<Finding>& findings, const std::vector<Finding>& others) {
  if (std::any_of(others.begin(), others.end(), IsUnverified)) return;
  std::erase_if(findings, IsUnverified);
  for (const Finding& other : others) {
    const auto same =
        std::find_if(findings.begin(), findings.end(),
                     [&](const Finding& f) { return f.measure == other.measure; });
    if (same == findings.end())
      findings.push_back(other);
    else if (Severity(other) > Severity(*same))
      *same = other;
  }
}

/** Simulates and judges the members of an ensemble other than the first, whose motion is
 `first`, and merges their findings into `groups`: answering first, then one group per
 claim. Returns the statistics of all members. */
EnsembleStatistics ExamineMembers(const WorldScenario& scenario, const Oracle& oracle,
                                  const Trajectory& first,
                                  std::vector<std::vector<Finding>>& groups) {
  std::vector<World> worlds;
  for (int index = 1; index < scenario.ensemble->members; ++index)
    worlds.push_back(MemberOf(scenario, index));
  std::vector<Trajectory> trajectories = oracle.SimulateEach(worlds);
  WorldScenario member = scenario;
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    member.world = std::move(worlds[i]);
    auto more = JudgeWorldByClaim({member, oracle.info(), trajectories[i]});
    for (std::size_t group = 0; group < more.size(); ++group) {
      for (Finding& finding : more[group])
        if (!finding.proof.empty())
          finding.proof =
              fmt::format("member {} of the ensemble: {}", i + 1, finding.proof);
      KeepWorst(groups[group], more[group]);
    }
  }
  trajectories.push_back(first);
  return StatisticsOf(scenario.world, trajectories);
}

/** Returns the world with every position moved by up to `nudge` [m] along each axis.
 Every body is also turned, by the angle that moves the surface of the largest body by as
 much: a body that spins about its middle axis amplifies rotations, not translations. The
 moves depend on `seed`. */
World Nudged(WorldScenario scenario, double nudge, unsigned seed) {
  scenario.ensemble = Ensemble{2, nudge, seed};
  World world = MemberOf(scenario, 1);
  const double radius = LargestRadius(world);
  if (radius == 0) return world;
  Random random({seed, 2});
  for (RigidBody& body : world.bodies) {
    if (body.mass == 0) continue;
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    for (double& half_angle : turn.vec())
      half_angle = random.Uniform(-nudge, nudge) / (2 * radius);
    Pose& X_WB = body.placed.X_WB;
    X_WB = Pose::FromQuaternion(X_WB.p_WB,
                                (turn * Eigen::Quaterniond(X_WB.R_WB)).normalized());
  }
  return world;
}

/** Returns the failures of a variant's motion under the claims of the world, except those
 that the world itself has too. The claims hold for the variant whether or not the two
 motions can be compared. */
std::vector<Finding> BrokenBy(const WorldVariant& variant, const Trajectory& moved,
                              const WorldScenario& scenario, const OracleInfo& oracle,
                              std::span<const Finding> of_world) {
  WorldScenario asked = scenario;
  asked.world = variant.world;
  asked.claims = ClaimsOf(variant, scenario.claims);
  std::vector<Finding> broken;
  for (Finding& found : JudgeWorld({asked, oracle, moved})) {
    if (found.verdict != Verdict::kFail) continue;
    const bool is_known =
        std::any_of(of_world.begin(), of_world.end(), [&](const Finding& known) {
          return known.law == found.law && known.measure == found.measure &&
                 known.verdict == Verdict::kFail;
        });
    if (is_known) continue;
    found.reference.clear();  // The failure is shown by a changed world.
    found.proof = fmt::format("the world {}: {}", ChangeOf(variant.measure), found.proof);
    broken.push_back(std::move(found));
  }
  return broken;
}

/** Returns the finding that the claim of that law could not be judged. */
Finding Unverified(const Study& study, std::string_view law) {
  Finding finding;
  finding.scenario = study.scenario.id;
  finding.oracle = study.oracle.name;
  finding.measure = MeasureKind::kAnswering;
  finding.law = law;
  finding.verdict = Verdict::kUnsupported;
  finding.tolerance_because = "an answer is an answer";
  finding.proof = fmt::format("{}: not every world with a moved start was answered", law);
  return finding;
}

/** The motions of the changed copies of a world by one oracle. All but `again` are left
 empty unless IsStudied(). */
struct Neighbours {
  Trajectory half;
  Trajectory quarter;
  std::vector<Trajectory> nudged;  ///< One; kNudgesOfStable for a stable world.
  std::vector<Trajectory> variants;
  Trajectory again;  ///< A second run; only with the claim `deterministic`.
};

/** Simulates all of them in one batch, so that an isolated oracle forks only once. */
Neighbours AskNeighbours(const WorldScenario& scenario, const Oracle& oracle,
                         double nudge, std::span<const WorldVariant> variants) {
  std::vector<World> worlds;
  std::vector<Trajectory*> places;
  Neighbours motions;
  motions.variants.resize(variants.size());
  motions.nudged.resize(Claims(scenario, kStable) ? kNudgesOfStable : 1);
  const auto ask = [&](World world, Trajectory& place) {
    worlds.push_back(std::move(world));
    places.push_back(&place);
  };
  if (IsStudied(scenario)) {
    ask(Refined(scenario.world, 2), motions.half);
    ask(Refined(scenario.world, 4), motions.quarter);
    for (std::size_t n = 0; n < motions.nudged.size(); ++n)
      ask(Nudged(scenario, nudge, static_cast<unsigned>(n) + 1), motions.nudged[n]);
    for (std::size_t v = 0; v < variants.size(); ++v)
      ask(variants[v].world, motions.variants[v]);
  }
  if (Claims(scenario, kDeterministic)) ask(scenario.world, motions.again);
  std::vector<Trajectory> given = oracle.SimulateEach(worlds);
  for (std::size_t i = 0; i < given.size(); ++i) *places[i] = std::move(given[i]);
  return motions;
}

/** Runs all simulations of one world by one oracle and returns their findings. Stores the
 motion of the world in `trajectory` and the statistics of its members in `ensemble`. */
std::vector<Finding> Examine(const WorldScenario& scenario, const Oracle& oracle,
                             Trajectory& trajectory, EnsembleStatistics& ensemble) {
  trajectory = oracle.Simulate(scenario.world);
  const double dt = scenario.world.dt;
  const bool studied = IsWhole(trajectory) && IsStudied(scenario);
  const double nudge = RoundingOf({scenario, oracle.info(), trajectory}, 1);
  const std::vector<WorldVariant> variants =
      studied ? VariantsOf(scenario.world) : std::vector<WorldVariant>();
  Neighbours motions;
  if (IsWhole(trajectory)) motions = AskNeighbours(scenario, oracle, nudge, variants);
  const auto& [half, quarter, nudged, moved, again] = motions;
  const bool refined = studied && IsWhole(half) && IsWhole(quarter);
  const Study study{scenario, oracle.info(), trajectory, refined ? &half : nullptr,
                    refined ? &quarter : nullptr};
  std::vector<std::vector<Finding>> groups = JudgeWorldByClaim(study);
  const bool answered = groups.front().front().verdict == Verdict::kPass;
  if (answered && scenario.ensemble)
    ensemble = ExamineMembers(scenario, oracle, trajectory, groups);
  std::vector<Finding> findings;
  for (std::vector<Finding>& group : groups)
    std::move(group.begin(), group.end(), std::back_inserter(findings));
  if (!answered) return findings;
  if (Claims(scenario, kDeterministic)) findings.push_back(JudgeRepetition(study, again));
  if (!studied) return findings;
  const auto add_failure = [&](const Trajectory& other, std::string_view asked,
                               double step) {
    const std::optional<Finding> failure = FailureToAnswer(study, other, asked, step);
    if (failure) findings.push_back(*failure);
  };
  add_failure(half, "at half the step", dt / 2);
  add_failure(quarter, "at a quarter of the step", dt / 4);
  const auto unanswered = std::find_if_not(nudged.begin(), nudged.end(), IsWhole);
  if (unanswered != nudged.end())
    add_failure(*unanswered, "with its start moved by a rounding", dt);
  RoundingGrowth growth;
  for (const Trajectory& other : nudged) {
    if (!refined || !IsWhole(other)) continue;
    const RoundingGrowth more = GrowthOf(study, other);
    if (more.gain > growth.gain) growth = more;
  }
  if (const Claim* stable = ClaimOf(scenario, kStable)) {
    const double most = stable->numbers.at(std::string(kStableGain));
    const double gain = std::min(growth.gain, most);
    const double late = LatenessOf(study);
    const Finding finding = unanswered == nudged.end()
                                ? JudgeStability(study, most, nudged)
                                : Unverified(study, kStable);
    // Lateness is granted only if a moved start shows it.
    const bool is_late = finding.value > finding.tolerance - late;
    growth = {.gain = gain, .gain_before = gain, .late = is_late ? late : 0};
    findings.push_back(finding);
  }
  const std::vector<Finding> of_world = findings;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const MeasureKind measure = variants[v].measure;
    add_failure(moved[v], ChangeOf(measure), dt);
    if (!refined || !IsWhole(moved[v])) continue;
    Finding finding =
        JudgeVariant(study, growth, measure, SeenInWorld(variants[v], moved[v]));
    if (finding.verdict != Verdict::kFail) {
      for (Finding& broken :
           BrokenBy(variants[v], moved[v], scenario, oracle.info(), of_world))
        findings.push_back(std::move(broken));
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace

bool IsStudied(const WorldScenario& scenario) {
  return BodySteps(scenario.world) <= kStudiedBodySteps;
}

std::size_t CountOfWorldRuns(std::span<const WorldScenario> worlds,
                             std::span<const Oracle* const> oracles) {
  return PairsOf(worlds, oracles).size();
}

WorldsReport RunWorlds(std::span<const WorldScenario> worlds,
                       std::span<const Oracle* const> oracles, int jobs,
                       const std::function<void()>& on_done) {
  WorldsReport report;
  for (const WorldScenario& scenario : worlds)
    report.worlds.push_back({scenario, std::vector<Trajectory>(oracles.size()),
                             std::vector<EnsembleStatistics>(oracles.size())});
  const std::vector<Pair> pairs = PairsOf(worlds, oracles);
  std::vector<std::vector<Finding>> findings(pairs.size());
  const std::vector<std::size_t> order = LongestFirst(pairs, worlds);
  ParallelFor(pairs.size(), jobs, [&](std::size_t turn) {
    const std::size_t i = order[turn];
    const auto [w, o] = pairs[i];
    findings[i] = Examine(worlds[w], *oracles[o], report.worlds[w].trajectories[o],
                          report.worlds[w].ensembles[o]);
    std::stable_sort(
        findings[i].begin(), findings[i].end(),
        [](const Finding& a, const Finding& b) { return a.measure < b.measure; });
    if (on_done) on_done();
  });
  for (std::vector<Finding>& of_pair : findings)
    std::move(of_pair.begin(), of_pair.end(), std::back_inserter(report.findings));
  return report;
}

}  // namespace touchstone
