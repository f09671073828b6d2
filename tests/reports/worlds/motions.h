#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "reports/worlds/law_support/law.h"

namespace touchstone {

/** Returns an engine in double precision that answers nothing: laws read its roundoff and
 name. */
const OracleInfo& DoubleEngine();

/** Returns the same in single precision. */
const OracleInfo& FloatEngine();

/** Returns a body of the catalogue's kind, for tests to change. */
RigidBody BodyOf(std::string_view name, const Shape& shape, double mass,
                 const Eigen::Vector3d& p_WB);

/** Returns a static half-space with outward normal `n_W` through the origin. */
RigidBody GroundOf(const Eigen::Vector3d& n_W = Eigen::Vector3d::UnitY());

/** Returns the world of a ball of 1 kg on the ground, in contact with a friction of 0.5.
 */
World BallOnRoughGround();

/** Returns the motion with the states `state_at`, sampled as the world specifies. */
Trajectory Sampled(const World& world, const std::function<WorldState(double)>& state_at);

/** Returns the motion that `step` advances by World::dt at a time, from the start. */
Trajectory Stepped(const World& world, const std::function<void(WorldState&)>& step);

/** Returns `q_WB` rotated by the rotation vector `angle_W` [rad]. */
Eigen::Quaterniond Turned(const Eigen::Quaterniond& q_WB, const Eigen::Vector3d& angle_W);

/** Returns a claim of that law about those names. */
Claim ClaimOf(std::string_view law, std::vector<std::string> about = {},
              std::map<std::string, double> numbers = {});

/** Judges the motion by the law that the claim names. @pre The claim has no faults. */
std::vector<LawFinding> Judge(const World& world, const Trajectory& trajectory,
                              const Claim& claim,
                              const OracleInfo& oracle = DoubleEngine());

/** Returns the law's faults of the claim. */
std::vector<Fault> FaultsOf(const World& world, const Claim& claim);

/** Returns the finding of that measure. @pre There is exactly one. */
LawFinding Of(const std::vector<LawFinding>& findings, MeasureKind measure);

/** Succeeds if every finding is within its tolerance; otherwise describes one that is
 not. */
testing::AssertionResult Passes(const std::vector<LawFinding>& findings);

/** Succeeds if the finding of that measure is beyond its tolerance and not recognised. */
testing::AssertionResult Finds(const std::vector<LawFinding>& findings,
                               MeasureKind measure);

/** Adds one kind of error after another to the second half of a right motion: to the
 place, velocity, orientation and spin of everything that moves, and to its impulses.
 Places and impulses are off along `direction`, velocities and spins along themselves.

 Succeeds if the law passes each error up to some size, and fails it at every larger size,
 half a decade apart from 1e-15 to 1e5 in SI units; and if it fails at least one kind. So
 no error grants itself its tolerance. Every fault must cite what its sentence names: the
 bodies, whatever they are called, the moment and the points. */
testing::AssertionResult TurnsOnce(const World& world, const Trajectory& right,
                                   const Claim& claim,
                                   const Eigen::Vector3d& direction = {0.2, -0.9, 0.3},
                                   const OracleInfo& oracle = DoubleEngine());

}  // namespace touchstone
