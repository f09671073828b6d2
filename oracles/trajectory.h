#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "oracles/contact_answer.h"

namespace touchstone {

/** The pose and velocity of a rigid body. World frame. */
struct BodyState {
  Eigen::Vector3d p_WB;     ///< Position of the centre of mass. [m]
  Eigen::Quaterniond q_WB;  ///< The engine's orientation, unit to its rounding.
  Eigen::Vector3d v_WB;     ///< Velocity of the centre of mass. [m/s]
  Eigen::Vector3d w_WB;     ///< Angular velocity. [rad/s]
};

/** The position and velocity of a particle or of a node of a cloth. World frame. */
struct PointState {
  Eigen::Vector3d p_W;  ///< [m]
  Eigen::Vector3d v_W;  ///< [m/s]
};

/** The state of a world at one moment. */
struct WorldState {
  std::vector<BodyState> bodies;  ///< Indexed like World::bodies, static ones included.
  std::vector<PointState> particles;  ///< Indexed like World::particles.
  /** The nodes of all cloths, cloth by cloth, row by row. */
  std::vector<PointState> nodes;
};

/** The impulse of one contact in one step. */
struct ContactImpulse {
  int step = 0;            ///< Number of the step, from 1; it ends at step · dt.
  int A = 0;               ///< Index into World::bodies.
  int B = 0;               ///< Index into World::bodies.
  Eigen::Vector3d p_WC;    ///< Point of application. [m]
  Eigen::Vector3d n_AB_W;  ///< Normal, unit, out of A into B.
  Eigen::Vector3d J_B_W;   ///< Impulse on B; A receives the opposite. [N s]
  /** Separation that the engine used when it solved the step: < 0 penetrating. [m] */
  double separation = 0;
  /** The first of two orthogonal directions along each of which the engine bounds
   friction on its own, unit; zero if the engine does not state it, or has another cone.
 */
  Eigen::Vector3d t_W = Eigen::Vector3d::Zero();
};

/** The motion of a world as an oracle computed it. */
struct Trajectory {
  AnswerStatus status = AnswerStatus::kUnsupported;
  std::string reason;               ///< Why there is no trajectory; empty when answered.
  std::vector<double> times;        ///< Times of the samples, from 0. [s]
  std::vector<WorldState> samples;  ///< One state for each time.
  /** All contact impulses of all steps, in the order of steps. Empty if the engine does
   not return them (`gives_impulses`). */
  std::vector<ContactImpulse> impulses;
  bool gives_impulses = false;
  /** The first step after which a number was not finite, or a position or speed was
   beyond 1e12 in SI units; 0 if there is none. The samples end before it. */
  int diverged_at_step = 0;
  /** The last line that an isolated engine printed to its standard error during the
   simulation, e.g. "LCP internal error": a sign of an internal failure, whatever the
   answer. Empty if it printed nothing. */
  std::string complaint;
  /** The time that the oracle took, by the clock on the wall; 0 if nobody looked. No
   judgement depends on it. [s] */
  double seconds = 0;
};

}  // namespace touchstone
