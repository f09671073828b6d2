#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/worlds/law_support/on_plane.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {

/** Holds a ball on a plane, that rolls or slips, against where and how it should move.

 Friction acts on what presses the contact: a velocity may be off by (1 + μ) of the ball's
 own velocity across the plane, and by δ/r of the velocity for a contact δ inside, × 1.5;
 by what the solver leaves and by rounding; and the spin by as much over the radius. */
class BallOnPlane {
 public:
  /** What the law says of an engine's errors at one time. */
  struct Errors {
    double speed;    ///< What solver and rounding take their share of. [m/s]
    double surface;  ///< What a contact inside changes a share of. [m/s]
    double ending;   ///< What an event a step early or late changes. [m/s]
    double lag;      ///< How far the scheme is behind, or ahead. [m]
  };

  /** `how` the ball moves, as in "rolling it moves at". @pre The body is a sphere. */
  BallOnPlane(const Motion& motion, int body, const OnPlane& on, std::string how,
              const std::string& velocity_because, const std::string& position_because);

  /** Takes sample `s`, where `truth` is the motion; its orientation is not read. */
  void Take(std::size_t s, const BodyState& truth, const Errors& errors);

  /** Returns those of position, velocity and spin. */
  std::vector<Worst> Findings() const { return {position_, velocity_, spin_}; }

 private:
  const Motion& motion_;
  int body_;
  OnPlane on_;
  std::string how_;
  Worst position_;
  Worst velocity_;
  Worst spin_;
};

}  // namespace touchstone
