#include <algorithm>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/worlds/study/every_step.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/truth/mechanics.h"
#include "tests/catalogue/the_catalogue.h"

namespace touchstone {
namespace {

/** Returns the info of a double-precision engine that answers every world but moves
 nothing. */
OracleInfo Frozen() {
  OracleInfo info;
  info.name = "frozen";
  info.simulates = true;
  return info;
}

/** Returns a trajectory without motion: each later sample is the initial state with its
 velocities multiplied by `left`. */
Trajectory FrozenMotion(const World& world, double left) {
  Trajectory trajectory;
  trajectory.status = AnswerStatus::kAnswered;
  const WorldState start = StateAtStart(world);
  WorldState later = start;
  for (BodyState& body : later.bodies) {
    body.v_WB *= left;
    body.w_WB *= left;
  }
  for (PointState& particle : later.particles) particle.v_W *= left;
  for (int step = 0; step <= world.steps; step += world.sample_every) {
    trajectory.times.push_back(step * world.dt);
    trajectory.samples.push_back(step == 0 ? start : later);
  }
  return trajectory;
}

bool IsFoundOut(const WorldScenario& scenario, double left) {
  const OracleInfo frozen = Frozen();
  const Trajectory of_steps = FrozenMotion(EveryStep(scenario.world), left);
  const Trajectory motion = SampledAs(scenario.world, of_steps);
  const std::vector<Finding> findings = JudgeWorld({.scenario = scenario,
                                                    .oracle = frozen,
                                                    .trajectory = motion,
                                                    .of_steps = &of_steps});
  return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.verdict != Verdict::kPass && finding.verdict != Verdict::kUnsupported;
  });
}

using Ids = std::set<std::string>;

Ids MissedWith(double left) {
  Ids missed;
  for (const WorldScenario& scenario : TheCatalogue().worlds)
    if (!IsFoundOut(scenario, left)) missed.insert(scenario.id);
  return missed;
}

/** Worlds in which standing still is the truth, or a legal answer to an overlap. */
const Ids kRest = {"world/cloth/strip",
                   "world/pile/boxes_at_rest_150",
                   "world/rest/box_on_a_slope",
                   "world/rest/boxes_set_down_askew",
                   "world/rest/card_leans_on_a_wall",
                   "world/rest/crossed_plates",
                   "world/rest/heavy_on_light",
                   "world/rest/overlap_is_resolved",
                   "world/rest/pyramid",
                   "world/rest/stack_of_five_boxes",
                   "world/rest/stack_of_spheres",
                   "world/rest/tilted_box_lies_down"};

/** Worlds that start at rest and move, but whose motion has no known closed form. A body
 that hangs still in the air obeys their claims too: it gains no energy, does not sink and
 stretches no rod. */
const Ids kStartAtRest = {"world/cloth/swings_by_one_corner",
                          "world/joint/box_on_a_rod",
                          "world/joint/heavy_below_light",
                          "world/joint/rope_of_ten",
                          "world/pile/elastic_27",
                          "world/pile/inelastic_27",
                          "world/rest/dropped_stack",
                          "world/zoo/mj_420"};

/** The same of worlds that start in motion: what is stopped at once obeys their claims.
 */
const Ids kStartInMotion = {
    "world/friction/spinning_block", "world/friction/twist_lets_slide",
    "world/impact/ball_strikes_a_groove", "world/impact/plank_lands_on_its_end",
    "world/rest/row_of_dominoes"};

TEST(Worlds, DetectAnEngineThatStopsEverything) {
  Ids known = kRest;
  known.insert(kStartAtRest.begin(), kStartAtRest.end());
  known.insert(kStartInMotion.begin(), kStartInMotion.end());
  EXPECT_EQ(MissedWith(0), known);
}

// Places follow velocities in every world, whatever it claims.
TEST(Worlds, DetectAnEngineThatKeepsVelocitiesButMovesNothing) {
  Ids known = kRest;
  known.insert(kStartAtRest.begin(), kStartAtRest.end());
  EXPECT_EQ(MissedWith(1), known);
}

}  // namespace
}  // namespace touchstone
