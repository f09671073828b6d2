#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "oracles/contact_answer.h"

namespace touchstone {

/** Where a rigid body is and how it moves. World frame. */
struct BodyState {
  Eigen::Vector3d p_WB;     ///< Of the centre of mass. [m]
  Eigen::Quaterniond q_WB;  ///< As the engine has it, unit to its rounding.
  Eigen::Vector3d v_WB;     ///< Of the centre of mass. [m/s]
  Eigen::Vector3d w_WB;     ///< [rad/s]
};

/** Where a particle, or a node of a cloth, is and how it moves. World frame. */
struct PointState {
  Eigen::Vector3d p_W;  ///< [m]
  Eigen::Vector3d v_W;  ///< [m/s]
};

/** A world at one moment. */
struct WorldState {
  std::vector<BodyState> bodies;      ///< As World::bodies, the static ones included.
  std::vector<PointState> particles;  ///< As World::particles.
  /** The nodes of all cloths, cloth by cloth, row by row. */
  std::vector<PointState> nodes;
};

/** What one contact did in one step. */
struct ContactImpulse {
  int step = 0;  ///< From 1: the step that ended at step · dt.
  int A = 0;     ///< Into World::bodies.
  int B = 0;
  Eigen::Vector3d p_WC;    ///< Where it acts. [m]
  Eigen::Vector3d n_AB_W;  ///< Unit, out of A into B.
  Eigen::Vector3d J_B_W;   ///< Impulse on B; A receives its opposite. [N s]
  /** As the engine saw it when it solved the step: < 0 penetrating. [m] */
  double separation = 0;
};

/** How a world moved, as an oracle says. */
struct Trajectory {
  AnswerStatus status = AnswerStatus::kUnsupported;
  std::string reason;               ///< Why there is none; empty when answered.
  std::vector<double> times;        ///< Of the samples, from 0. [s]
  std::vector<WorldState> samples;  ///< One for each time.
  /** All contact impulses of all steps, in the order of steps; empty where the engine
   does not give them (`gives_impulses`). */
  std::vector<ContactImpulse> impulses;
  bool gives_impulses = false;
  /** The first step after which a number was not finite, or a place or a speed beyond
   1e12 in SI units; 0: none. The samples end before it. */
  int diverged_at_step = 0;
  /** The last line that an isolated engine printed to its standard error as it ran, e.g.
   "LCP internal error": a sign that it failed at something, whatever it then answered.
   Empty: nothing. */
  std::string complaint;
};

}  // namespace touchstone
