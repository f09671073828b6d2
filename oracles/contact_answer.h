#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scenarios/eigen_alignment.h"

namespace touchstone {

/** The status of an answer. */
enum class AnswerStatus {
  kAnswered,     ///< The other fields hold the oracle's answer.
  kUnsupported,  ///< The oracle does not support the query. Expected, counted and shown.
  kCrashed,      ///< The engine threw, aborted or was killed by a signal. A finding.
  kTimedOut,     ///< The engine did not answer before its deadline. A finding.
};

/** One contact. */
struct ContactPoint {
  /** Position on the plane midway through the overlap (or gap) at this contact: p_WC ∓
   n_AB_W separation / 2 lie on the surfaces of A (−) and B (+). Adapters shift the
   positions of their library to this convention. World frame, [m]. */
  Eigen::Vector3d p_WC;
  double separation;  ///< Signed gap along the normal: < 0 penetrating. [m]
  /** The normal of this contact, if the library returns one per contact and it differs
   from ContactAnswer::n_AB_W. Unit, from A to B, world frame. */
  std::optional<Eigen::Vector3d> n_AB_W;
};

/** A pair of nearest (or, when penetrating, deepest) points. */
struct WitnessPoints {
  Eigen::Vector3d p_WCa;  ///< Point on the surface of A. World frame, [m].
  Eigen::Vector3d p_WCb;  ///< Point on the surface of B. World frame, [m].
};

/** An oracle's answer to a ContactQuery, in the project's conventions.

 A field that the oracle does not provide is empty. A field that it provides is passed on
 unchanged, NaN included, since a NaN is a finding.

 `n_AB_W` points out of A into B: moving B by -separation * n_AB_W makes the two just
 touch. Swapping A and B negates the normal and changes nothing else. */
struct ContactAnswer {
  AnswerStatus status = AnswerStatus::kUnsupported;
  std::string reason;     ///< Why there is no answer; empty when answered.
  bool touching = false;  ///< The oracle's decision; zero separation is touching.
  std::optional<Eigen::Vector3d> n_AB_W;  ///< Unit, world frame.
  std::optional<double> separation;       ///< Signed: < 0 penetrating, > 0 apart. [m]
  std::vector<ContactPoint> points;       ///< Empty if apart or not provided. Unordered.
  std::optional<WitnessPoints> witnesses;
  /** The time that the oracle took, by the clock on the wall; 0 if nobody looked. No
   judgement depends on it. [s] */
  double seconds = 0;
};

}  // namespace touchstone
