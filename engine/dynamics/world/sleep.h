#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/body/settings.h"
#include "engine/dynamics/contacts/contact_cache.h"
#include "engine/dynamics/solver/union_find.h"

namespace cookbook {

/** Which bodies sleep.

 An island is all moving bodies that are linked, or near each other as the broad phase
 sees them; static ones join none. It falls asleep when each of its bodies has been slow
 for Settings::sleep_after; what a force moves and nothing holds is not slow, even where
 it turns back. It wakes, all of it, as soon as a body that is awake comes
 near one of its own, which is before the two touch, or something pushes one of them.

 A body that sleeps has no velocity, and is static to everything else. */
class Sleep {
 public:
  /** Adds the body of the next index, awake. */
  void Add(const RigidBody& body);

  /** Puts two bodies into the same island, whatever is near. −1: the world, in no island.
   */
  void Link(int A, int B);

  bool IsAsleep(int body) const { return asleep_[static_cast<std::size_t>(body)]; }

  /** By body: whether it sleeps. */
  const std::vector<bool>& asleep() const { return asleep_; }

  /** Wakes the island of a body. */
  void Wake(int body, std::span<RigidBody> bodies);

  /** Wakes the islands that something awake has come near. */
  void WakeNear(const ContactCache& cache, std::span<RigidBody> bodies);

  /** Ends a step of `h` [s]: lets fall asleep what has been slow for long. `driven`: by
   body, whether a force moves it that nothing holds. Returns whether anything did.
   @pre Settings::sleep_after is there. */
  bool PutToSleep(const ContactCache& cache, const std::vector<bool>& driven,
                  const Settings& settings, double h, std::span<RigidBody> bodies);

 private:
  /** What a body is given back when it wakes. */
  struct Inertia {
    double inverse_mass;
    Eigen::Vector3d inverse_moments;
  };

  std::vector<Inertia> inertias_;  ///< By body, as the following.
  std::vector<bool> asleep_;
  std::vector<double> slow_for_;  ///< [s]
  std::vector<double> slowest_;   ///< By body that stands for an island: least slow_for_.
  std::vector<int> next_;         ///< The next that sleeps in its island, in a ring.
  UnionFind islands_;             ///< Of bodies that are awake.
  std::vector<std::pair<int, int>> links_;
};

}  // namespace cookbook
