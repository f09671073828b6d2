#pragma once

#include <optional>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/impact.h"

namespace touchstone {

/** A single impact of a sphere on another sphere or on a static plane. */
struct SphereMeeting {
  /** One of the two bodies, in flight along x₀ + v₀ t + ½ a t². */
  struct Side {
    int body = -1;      ///< Index into World::bodies.
    double radius = 0;  ///< Radius; 0 for a plane. [m]
    Striker start;      ///< State at the start; without mass if it is static.
    Eigen::Vector3d a_W = Eigen::Vector3d::Zero();
    /** Tangential response of the surface to an impulse, times the mass: 1 + 1/k for I =
     k m r². */
    double size = 0;
  };

  Side A;
  Side B;
  std::optional<Eigen::Vector3d> n_AB_W;  ///< Outward normal of A if A is a plane.
  double restitution = 0;
  double friction = 0;
  double time = 0;  ///< Time at which they touch. [s]

  /** Returns the contact normal from A to B at time `t`. */
  Eigen::Vector3d NormalAt(double t) const;
};

/** Both sides of an impact at one moment. */
struct BothSides {
  Striker A;
  Striker B;
};

/** Returns both sides after `t`. The impact acts at time `impact` [s], at points that lie
 `inset` [-] of the overlap inside the spheres, with friction by `cone`. */
BothSides SidesAt(const SphereMeeting& meeting, double t, double impact, double inset,
                  const PlacedCone& cone);

/** Both sides just before and just after their impact. */
struct Outcome {
  BothSides before;
  BothSides after;

  /** Returns the kinetic energy after the impact over that before it. */
  double EnergyRatio() const;
};

/** Returns the outcome of the impact at its time, with Coulomb's circular cone. */
Outcome OutcomeOf(const SphereMeeting& meeting);

/** Returns the time at which two spheres A and B first touch; NaN if they never do. */
double TouchTime(const SphereMeeting::Side& A, const SphereMeeting::Side& B);

/** Returns the side of the impact that is body `index`, a moving sphere. */
SphereMeeting::Side SideOf(const World& world, int index);

/** Returns the reason why body `index` is not a sphere in free flight; empty if it is. */
std::string WhyNoFreeSphere(const World& world, int index);

/** Judges both sides by the closed form of their impact until `until` [s]: velocity,
 spin, position, and the restitution of the normal velocity.

 The tolerance is 1.5 times the largest deviation of the same closed form over two
 changes. The impact is up to a step early or late, or a little later for one that falls
 on a step. Its point is up to the whole overlap inside the spheres, where engines put it.
 Added are gravity's effect in a step, the error of semi-implicit Euler, 1e-5 of the
 velocity for the solver, and 64 roundings per step. Other friction cones are recognised
 if the contact slips (law_support/cone_models.h). */
std::vector<LawFinding> JudgeMeeting(const Motion& motion, const SphereMeeting& meeting,
                                     double until);

}  // namespace touchstone
