#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

namespace touchstone {

/** A place, in [m], a velocity, in [m/s], or a spin, in [rad/s]. World frame. */
struct ExpectedVector {
  enum class Of { kPosition, kVelocity, kSpin };
  Of of = Of::kPosition;
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  /** Only the component along this direction, of any length, is expected; absent: all
   three. */
  std::optional<Eigen::Vector3d> along;
};

/** An orientation of the body in the world. */
struct ExpectedOrientation {
  Eigen::Quaterniond q_WB = Eigen::Quaterniond::Identity();
};

/** The angle by which the body has turned about `axis` since the start, counter-clockwise
 seen from its tip, up to whole turns. */
struct ExpectedAngle {
  double angle = 0;                                 ///< [rad]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Any length. World frame.
};

/** The first contact with another body. */
struct ExpectedTouch {
  std::string other;
};

/** Whether the direction of the body that was up at the start tilts by more than 45°. */
struct ExpectedTopple {
  bool topples = true;
};

/** No point of the body moves faster than the tolerance, from a time to the end. */
struct ExpectedRest {};

/** A state of a reference trajectory. */
struct ReferenceState {
  double time = 0;                                ///< [s]
  std::string name;                               ///< Name of a body or a particle.
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  std::optional<Eigen::Quaterniond> q_WB;         ///< Absent for a particle.
  int line = 0;                                   ///< In the file.
};

/** A trajectory from a file of the columns that `touchstone simulate` writes. */
struct ExpectedTrajectory {
  std::string file;  ///< Path as stated: relative to the scenario's own file.
  std::vector<ReferenceState> states;
};

/** A plain statement of an author about a motion, checked for every engine. */
struct MotionExpectation {
  std::string body;  ///< A body or particle; "" with a trajectory: all that it names.
  /** The time of what is stated: at it, for an event by it, for rest from it on. [s] */
  double time = 0;
  /** In the unit of what is stated: m, rad, m/s, rad/s; s for a touch. Unused for a
   topple. A trajectory's is the distance of any point of the body. [m] */
  double tolerance = 0;
  std::variant<ExpectedVector, ExpectedOrientation, ExpectedAngle, ExpectedTouch,
               ExpectedTopple, ExpectedRest, ExpectedTrajectory>
      what;
  std::string because;  ///< The derivation or the citation; may be empty.
};

}  // namespace touchstone
