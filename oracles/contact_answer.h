#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** How a question ended. */
enum class AnswerStatus {
  kAnswered,     ///< The fields below hold what the oracle says.
  kUnsupported,  ///< The oracle has no such query. Expected, counted and shown.
  kCrashed,      ///< The engine threw, aborted or died of a signal. A finding.
  kTimedOut,     ///< The engine had not answered when its deadline passed. A finding.
};

/** One contact. */
struct ContactPoint {
  /** On the plane midway through the overlap (or gap) at this contact: p_WC ∓ n_AB_W
   separation / 2 lie on the surfaces of A (−) and B (+). Adapters shift what their
   library gives to this convention. World frame, [m]. */
  Eigen::Vector3d p_WC;
  double separation;  ///< Signed gap along the normal: < 0 penetrating. [m]
  /** The normal of this contact where the library gave it one of its own that differs
   from ContactAnswer::n_AB_W. Unit, from A to B, world frame. */
  std::optional<Eigen::Vector3d> n_AB_W;
};

/** A pair of nearest (or, when penetrating, deepest) points. */
struct WitnessPoints {
  Eigen::Vector3d p_WCa;  ///< On the surface of A. World frame, [m].
  Eigen::Vector3d p_WCb;  ///< On the surface of B. World frame, [m].
};

/** What an oracle says about a ContactQuery, in the project's conventions.

 A field that the oracle does not provide is empty; a field that it provides is passed on
 as it came, NaN included, since that is a finding.

 `n_AB_W` points out of A into B: moving B by -separation * n_AB_W brings the two to just
 touching. Swapping A and B negates the normal and nothing else. */
struct ContactAnswer {
  AnswerStatus status = AnswerStatus::kUnsupported;
  std::string reason;  ///< Why there is no answer; empty when answered.
  bool touching =
      false;  ///< What the oracle decides, zero separation counting as touching.
  std::optional<Eigen::Vector3d> n_AB_W;  ///< Unit, world frame.
  std::optional<double> separation;       ///< Signed: < 0 penetrating, > 0 apart. [m]
  std::vector<ContactPoint> points;  ///< Empty where apart or not provided. Unordered.
  std::optional<WitnessPoints> witnesses;
};

}  // namespace touchstone
