#pragma once

#include <optional>
#include <vector>

#include "reports/worlds/law_support/law.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/impact.h"

namespace touchstone {

/** A sphere that meets another, or a static plane, once. */
struct SphereMeeting {
  /** One side of it, flying along x₀ + v₀ t + ½ a t². */
  struct Side {
    int body = -1;      ///< Into World::bodies.
    double radius = 0;  ///< 0 for a plane. [m]
    Striker start;      ///< Without mass where it never moves.
    Eigen::Vector3d a_W = Eigen::Vector3d::Zero();
    double size = 0;  ///< 1 + 1/k, I = k m r²: how much a blow at the surface moves it.
  };

  Side A;
  Side B;
  std::optional<Eigen::Vector3d> n_AB_W;  ///< Where A is a plane: its outward normal.
  double restitution = 0;
  double friction = 0;
  double time = 0;  ///< When they touch. [s]

  /** Returns the normal and the contact's place as they are after `t`. */
  Eigen::Vector3d NormalAt(double t) const;
};

/** Both sides of a meeting at one moment. */
struct Met {
  Striker A;
  Striker B;
};

/** Returns both as they are after `t`, where the impact acts at `impact` [s] at points
 that lie `inset` [-] of the overlap inside the spheres, with friction by `cone`. */
Met MetAt(const SphereMeeting& meeting, double t, double impact, double inset,
          const PlacedCone& cone);

/** Returns when two spheres A and B first touch, NaN where they never do. */
double TouchTime(const SphereMeeting::Side& A, const SphereMeeting::Side& B);

/** Returns the side that moving body `index`, a sphere, is. */
SphereMeeting::Side SideOf(const World& world, int index);

/** Returns what keeps body `index` from flying freely as a sphere; empty where it does.
 */
std::string WhyNoFreeSphere(const World& world, int index);

/** Holds both against the closed form of their impact until `until` [s]: velocity, spin,
 position, and the restitution of the normal velocity. The tolerance is 1.5 times the
 largest deviation of the same closed form with the impact up to a step (and a little, for
 one that falls on a step) early or late, and with its point up to the whole overlap
 inside the spheres, where engines put it; what gravity does in a step; the error of
 semi-implicit Euler; 1e-5 of the velocity for the solver; and 64 roundings a step. Other
 friction cones are recognised, where the contact slips (laws/cone_models.h). */
std::vector<LawFinding> JudgeMeeting(const Motion& motion, const SphereMeeting& meeting,
                                     double until);

}  // namespace touchstone
