#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** An engine in double precision that answers nothing: laws read its roundoff and name.
 */
const OracleInfo& DoubleEngine();

/** The same in single precision. */
const OracleInfo& FloatEngine();

/** Returns a body of the catalogue's kind, for tests to change. */
RigidBody BodyOf(std::string_view name, const Shape& shape, double mass,
                 const Eigen::Vector3d& p_WB);

/** Returns an immovable half-space with outward normal `n_W` through the origin. */
RigidBody GroundOf(const Eigen::Vector3d& n_W = Eigen::Vector3d::UnitY());

/** Returns the motion that `state_at` says, sampled as the world asks. */
Trajectory Sampled(const World& world, const std::function<WorldState(double)>& state_at);

/** Returns the motion of which `step` makes one step of World::dt after another, from the
 start. */
Trajectory Stepped(const World& world, const std::function<void(WorldState&)>& step);

/** Turns `q_WB` by the rotation vector `angle_W` [rad]. */
Eigen::Quaterniond Turned(const Eigen::Quaterniond& q_WB, const Eigen::Vector3d& angle_W);

/** Returns a claim of that law about those names. */
Claim ClaimOf(std::string_view law, std::vector<std::string> about = {},
              std::map<std::string, double> numbers = {});

/** Holds the motion against the law that the claim names. @pre The claim has no faults.
 */
std::vector<LawFinding> Judge(const World& world, const Trajectory& trajectory,
                              const Claim& claim,
                              const OracleInfo& oracle = DoubleEngine());

/** Returns the law's faults of the claim. */
std::vector<Fault> FaultsOf(const World& world, const Claim& claim);

/** Returns the finding of that measure. @pre There is exactly one. */
LawFinding Of(const std::vector<LawFinding>& findings, MeasureKind measure);

/** Returns whether every finding is within its tolerance, or names those that are not. */
testing::AssertionResult Passes(const std::vector<LawFinding>& findings);

/** Returns whether the finding of that measure is beyond its tolerance and not
 * recognised.
 */
testing::AssertionResult Finds(const std::vector<LawFinding>& findings,
                               MeasureKind measure);

}  // namespace touchstone
