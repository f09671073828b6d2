#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/contacts/contact_cache.h"
#include "engine/dynamics/solver/union_find.h"

namespace cookbook {

/** Deactivation of bodies at rest.

 A sleep island is a set of dynamic bodies that joints or springs connect, or that are
 neighbours in the broad phase. It is larger than an island of the solver, which contacts
 connect. Static bodies are in no island. An island falls asleep when each of its bodies
 has been slow for Settings::sleep_after. A body that a force accelerates and nothing
 holds does not count as slow, even at its turning point. All of the island wakes when an
 awake body comes near one of its bodies, which is before the two touch, or when an
 impulse or a force is applied to one of them.

 A sleeping body has no velocity, and is static for all other classes. */
class Sleep {
 public:
  /** Adds the body of the next index, awake. */
  void Add(const RigidBody& body);

  /** Connects two bodies, so that they are always in the same island. −1: the world,
   which is in no island. */
  void Link(int A, int B);

  bool IsAsleep(int body) const { return asleep_[static_cast<std::size_t>(body)]; }

  /** Indexed by body: whether it sleeps. */
  const std::vector<bool>& asleep() const { return asleep_; }

  /** Wakes the island of a body. */
  void Wake(int body, std::span<RigidBody> bodies);

  /** Wakes the islands that an awake body has come near. */
  void WakeNear(const ContactCache& cache, std::span<RigidBody> bodies);

  /** Ends a step of `h` [s]: puts islands to sleep that have been slow for long enough.
   `driven`, indexed by body, is true if a force accelerates the body and nothing holds
   it. Returns whether any body fell asleep.
   @pre Settings::sleep_after has a value. */
  bool PutToSleep(const ContactCache& cache, const std::vector<bool>& driven,
                  const Settings& settings, double h, std::span<RigidBody> bodies);

 private:
  /** The inverse inertia of an awake body. A sleeping one has zero, like a static body.
   */
  struct Inertia {
    double inverse_mass;
    Eigen::Vector3d inverse_moments;
  };

  std::vector<Inertia> inertias_;      ///< Indexed by body.
  std::vector<bool> asleep_;           ///< Indexed by body.
  std::vector<double> slow_time_;      ///< Indexed by body. [s]
  std::vector<double> min_slow_time_;  ///< Indexed by root: least of its island. [s]
  std::vector<int> next_in_island_;    ///< Circular list of a sleeping island.
  UnionFind islands_;                  ///< Islands of awake bodies.
  std::vector<std::pair<int, int>> links_;
};

}  // namespace cookbook
