#pragma once

#include <array>

#include "oracles/trajectory.h"
#include "reports/worlds/law_support/law.h"
#include "reports/worlds/truth/sliding.h"

namespace touchstone {

/** Returns how far an impulse with the tangential part `tangential` [N s] is outside the
 set that a contact can apply; NaN if its normal part is not finite. [N s] */
double ViolationOf(const ContactImpulse& contact, double friction, double tangential);

/** Returns the error that a solver may leave in `contact`, of bodies A and B that it
 names: 1e-5 of the impulse and of the pair's gravity impulse in a step, and 64 roundings.
 [N s] */
double ConeToleranceOf(const Motion& motion, const ContactImpulse& contact);

/** Returns the friction √(μ_A μ_B) of the two bodies of `contact`. [-] */
double FrictionOf(const World& world, const ContactImpulse& contact);

/** Tests whether impulses follow the box cone, which bounds the larger tangential
 component instead of the tangential magnitude.

 The engine states its friction directions, as Bullet does, which turns them into the
 slip. Or they follow from the normal by one rule for a whole motion: the
 projection of one world axis. Which axis that is depends on which component of the normal
 exceeds √½, if any. At least one impulse must be beyond the circle and as large as the
 box allows. Impulses inside the box alone only show too much friction. */
class BoxCone {
 public:
  void Take(const ContactImpulse& contact, double friction, bool beyond_circle,
            double tolerance);

  bool IsFollowed() const;

  /** Returns whether an impulse beyond the circle is on the boundary of the box that the
   engine states. */
  bool IsShownAsStated() const { return stated_.shows; }

  /** Returns the larger component of friction along the directions that the engine states
   for `contact`. [N s] */
  static double LargerAsStated(const ContactImpulse& contact);

 private:
  /** A rule for the friction directions: one world axis, or what the engine states. */
  struct Axis {
    bool fits = true;    ///< Every impulse is inside the box.
    bool shows = false;  ///< An impulse beyond the circle is on the box's boundary.
  };

  static void Take(const ContactImpulse& contact, double friction, bool beyond_circle,
                   double tolerance, const TangentFrame& frame, Axis& axis);

  Axis stated_;  ///< For contacts with directions that the engine states.
  /** Indexed by the normal's component above √½, or 3 if there is none. */
  std::array<std::array<Axis, 3>, 4> axes_;
};

/** Returns whether the friction of a motion follows a box cone with directions that are
 fixed in the world. Contacts of two bodies in a step that have one normal are summed: ODE
 bounds the friction of each by the normal impulse that it has without friction, and only
 their sum shows the box.
 Source: ODE manual, "Friction Approximation". */
bool FollowsBoxCone(const Motion& motion);

}  // namespace touchstone
