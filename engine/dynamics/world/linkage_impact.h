#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "engine/dynamics/contacts/contact_pair.h"
#include "engine/dynamics/joints/distance_joint.h"
#include "engine/dynamics/joints/rod_projection.h"
#include "engine/dynamics/solver/step_context.h"

namespace cookbook {

/** An impact on bodies that rods connect: Newton's restitution and Coulomb's friction at
 the contacts, while the rods keep their lengths. No time passes and no force acts.

 Projected Gauss-Seidel over the contacts. The effective mass of a contact is that of the
 whole linkage: each impulse is followed by the RodProjection. Before the impact the rods
 lose the small rates of their lengths that a step leaves, so that they do no work in it.
 The energy then changes by ½ Σ J·(u₀ + u₁), where u₀ and u₁ are the relative velocities
 at a contact before and after. If that is positive, the impulses are reduced: first like
 those of RestitutionLimit, then by a common factor, which takes what the iterations have
 left. */
class LinkageImpact {
 public:
  /** The bodies of the world, and the pairs and rods of one island. */
  struct Island {
    std::span<const RigidBody> bodies;
    std::span<const InverseInertia> inertias;
    std::span<const ContactPair> pairs;  ///< With all contacts that take part.
    std::span<const DistanceJoint> joints;
  };

  /** Changes `velocities`, which are indexed by body. Appends the pairs with nonzero
   impulses to `impact_contacts`. */
  void Solve(const Island& island, const StepContext& step,
             std::span<Velocity> velocities, std::vector<ContactPair>& impact_contacts);

 private:
  /** A contact. The axes of its vectors are n, t₁ and t₂. */
  struct Contact {
    std::size_t pair;
    std::size_t point;
    int A;
    int B;
    Eigen::Matrix3d axes_W;  ///< Its columns are the axes.
    Eigen::Vector3d r_A;     ///< [m]
    Eigen::Vector3d r_B;     ///< [m]
    Eigen::Vector3d u_before;
    double restitution;
    double friction;
    double threshold;  ///< Approach beyond which it bounces. [m/s]
    /** Change of its relative velocity per impulse, with the rods. [1/kg] */
    Eigen::Matrix3d response;
    Eigen::Vector3d impulse;  ///< On B. [N s]
  };
  /** The impulses of all contacts, and the velocities after them. */
  struct Solution {
    std::vector<Eigen::Vector3d> impulses;
    std::vector<Velocity> velocities;
  };

  void CollectContacts(const Island& island, const StepContext& step);
  Eigen::Vector3d RelativeVelocity(const Contact& contact,
                                   std::span<const Velocity> velocities) const;
  /** Applies an impulse, in the axes of the contact, and projects. */
  void Apply(const Contact& contact, const Eigen::Vector3d& impulse,
             std::span<Velocity> velocities);
  /** Returns the change of the impulse of a contact with the relative velocity `u`. */
  static Eigen::Vector3d ChangeOf(const Contact& contact, double target,
                                  const Eigen::Vector3d& u);
  /** Solves the impact with the restitutions times `restitution_factor`. */
  Solution SolveContacts(double restitution_factor, const StepContext& step);
  /** Returns the work of the impulses `J` at the mean of the velocities before and
   `after` the impact. [J] */
  double WorkOf(const Solution& solution) const;
  /** Returns the error of that by rounding. [J] */
  double RoundingOf(const Solution& solution) const;
  /** Returns (1 − s) a + s b. */
  static Solution Mean(double s, const Solution& a, const Solution& b);

  std::span<const InverseInertia> inertias_;
  RodProjection rods_;
  std::vector<Contact> contacts_;
  std::vector<Velocity> before_;
};

}  // namespace cookbook
